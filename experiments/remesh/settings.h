#pragma once

#include <string>

#include "cirque/core/option_table.h"
#include "cirque/pipeline/options.h"
#include "cirque/remesh/remesh_surface.h"

#include "experiments/common/flag_parsing.h"
#include "experiments/common/manual.h"

namespace cirque {

/// What the flags of remesh say: of the mesh that is wanted, and of the map that it is made by.
struct RemeshSettings {
  RemeshOptions mesh;
  ParameterizeOptions map;
  std::string repair = "safe";
  std::string density, correspondence, report;
  bool quads = false, measure = false, quiet = false;
};

Manual RemeshManual();

/// The flags, bound to the settings: those of this program, and those of the map that tell metrics
/// apart (a layout and its seams are of no use here).
CommandLine RemeshFlags(RemeshSettings* settings);

/// Whether they go together.
Status CheckSettings(const RemeshSettings& settings);

}  // namespace cirque

#pragma once

#include <functional>
#include <string>

#include "cirque/core/types.h"
#include "cirque/mesh/polygon_soup.h"
#include "cirque/pipeline/certificate.h"

#include "experiments/run_experiment/cells.h"

namespace cirque {

/// What a run leaves behind. The certificate's outcome and message are always set.
struct RunResult {
  Index vertices = 0, triangles = 0;  ///< of the mesh; 0 when it could not be read
  Certificate certificate;
  PolygonSoup map = {};  ///< the mesh with its map, where the cell keeps it and there is one
};

/// Carries out one run; `mesh_path` is the mesh's file, empty for a generated mesh.
using RunCell = std::function<RunResult(const Cell& cell, const std::string& mesh_path)>;

/// The real one: read or generate, preflight, parameterize.
RunResult ParameterizeCell(const Cell& cell, const std::string& mesh_path);

}  // namespace cirque

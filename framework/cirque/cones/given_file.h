#pragma once

#include <string>

#include "cirque/core/option_table.h"
#include "cirque/core/status.h"
#include "cirque/io/cone_file.h"

namespace cirque {

/// Of `given`, the cone heuristic and the boundary shape: where the angle sums stand.
struct GivenOptions {
  std::string file;
};

/// The table of its field.
const OptionTable<GivenOptions>& GivenOptionTable();

/// Those angle sums. Errors: kInvalidInput without a file; as of ReadConeFile.
StatusOr<ConeTargets> ReadGiven(const GivenOptions& options, const Triangulation& triangulation,
                                const FileVertices& vertices);

}  // namespace cirque

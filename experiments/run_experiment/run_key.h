#pragma once

#include <string>

#include "cirque/core/status.h"

#include "experiments/run_experiment/cells.h"

namespace cirque {

/// Names a run by all that determines it: the cell, the contents of the mesh and of the files that
/// its method names (wherever they lie), the code. Error (invalid input): such a file cannot be
/// read.
StatusOr<std::string> RunKey(const Cell& cell, const std::string& mesh_hash,
                             const std::string& code_version);

}  // namespace cirque

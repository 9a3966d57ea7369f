#pragma once

#include <nlohmann/json.hpp>

#include "cirque/core/status.h"

#include "experiments/run_experiment/config/planned_run.h"

namespace cirque {

/// A method with every option, files (of edge costs, of cones) by the hash of what they hold
/// instead of by name. Error (invalid input): such a file cannot be read.
StatusOr<nlohmann::json> MethodByContent(const MethodSpec& method);

}  // namespace cirque

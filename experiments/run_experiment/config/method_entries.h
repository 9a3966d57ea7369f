#pragma once

#include <vector>

#include <yaml-cpp/yaml.h>

#include "experiments/run_experiment/config/diagnostics.h"
#include "experiments/run_experiment/config/planned_run.h"

namespace cirque {

/// The methods of a config, which the schema has let pass, their lists of values expanded.
/// Reported: two equal names, a key that has no meaning for a domain of the entry, and options that do
/// not go together.
std::vector<MethodSpec> ReadMethods(const YAML::Node& list, Diagnostics* problems);

}  // namespace cirque

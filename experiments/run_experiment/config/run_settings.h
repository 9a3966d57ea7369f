#pragma once

#include <yaml-cpp/yaml.h>

#include "experiments/run_experiment/config/config.h"
#include "experiments/run_experiment/config/diagnostics.h"

namespace cirque {

/// One value or a list of them; nothing where the key is not given.
std::vector<YAML::Node> ItemsOf(const YAML::Node& value);

/// Takes to the runs what a config says of them all: `include` and `exclude`, `time_limit` and
/// `memory_limit`, `keep_maps`, `reference`, `measures`. A pattern that names no run is a problem,
/// unless `some_skipped`: it may have meant runs on meshes that do not exist here.
void ApplyRunSettings(const YAML::Node& document, bool some_skipped, Diagnostics* problems,
                      ExperimentConfig* config);

}  // namespace cirque

#pragma once

#include <yaml-cpp/yaml.h>

#include "experiments/run_experiment/config/config_text.h"
#include "experiments/run_experiment/config/schema_field.h"

namespace cirque {

/// The keys of entries of `methods` that minimise an energy by itself.
Schema EnergyFields();

/// Reports the keys of an entry that have no meaning beside `energy`.
void CheckEnergyEntry(const YAML::Node& entry, Diagnostics* problems);

}  // namespace cirque

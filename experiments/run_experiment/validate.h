#pragma once

#include <yaml-cpp/yaml.h>

#include "experiments/run_experiment/diagnostics.h"
#include "experiments/run_experiment/schema.h"

namespace cirque {

/// Holds the document against the schema and reports everything that is wrong with it: keys that
/// are unknown, missing, doubled or in the wrong company; values of the wrong type or out of range;
/// empty lists.
void Validate(const YAML::Node& document, const Schema& schema, Diagnostics* problems);

}  // namespace cirque

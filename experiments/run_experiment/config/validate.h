#pragma once

#include <yaml-cpp/yaml.h>

#include "experiments/run_experiment/config/diagnostics.h"
#include "experiments/run_experiment/config/schema.h"

namespace cirque {

/// Holds the document against the schema and reports everything that is wrong with it: keys that
/// are unknown, missing, doubled or in the wrong company; values of the wrong type or out of range;
/// empty lists.
void Validate(const YAML::Node& document, const Schema& schema, Diagnostics* problems);

/// Puts what keys and choices are called now where the document has what they were called once.
/// Returns a line for each old word, of its first place.
std::vector<std::string> UseNewWords(const YAML::Node& document, const Schema& schema,
                                     const Diagnostics& places);

}  // namespace cirque

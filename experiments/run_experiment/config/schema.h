#pragma once

#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "experiments/run_experiment/config/config_text.h"
#include "experiments/run_experiment/config/schema_field.h"

namespace cirque {

/// Every key that a config may have, in the order of its documentation.
const Schema& ConfigSchema();

/// The keys of the entries of `meshes`.
Schema MeshSchema();

/// The largest seed of anything random.
inline constexpr double kMaxSeed = 4294967295.0;

/// The fields whose parent is `path` ("" for the top of the file).
std::vector<const SchemaField*> FieldsOf(const Schema& schema, const std::string& path);

/// What a value must be: "a whole number from 1 to 1000", "one of a, b".
std::string Expectation(const SchemaField& field);

/// The reference of the config file as text, with an example.
std::string ConfigHelp(const Schema& schema);

/// The same as the page experiments/CONFIG.md.
std::string ConfigMarkdown(const Schema& schema);

/// Holds the document against the schema and reports everything that is wrong with it: keys that
/// are unknown, missing, doubled or in the wrong company; values of the wrong type or out of range;
/// empty lists.
void Validate(const YAML::Node& document, const Schema& schema, Diagnostics* problems);

/// Puts what keys and choices are called now where the document has what they were called once.
/// Returns a line for each old word, of its first place.
std::vector<std::string> UseNewWords(const YAML::Node& document, const Schema& schema,
                                     const Diagnostics& places);

}  // namespace cirque

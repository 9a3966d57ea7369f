#pragma once

#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "cirque/core/option.h"

#include "experiments/run_experiment/config/config_text.h"

namespace cirque {

enum class FieldKind { kText, kInteger, kNumber, kBoolean, kSections };

/// One key of a config. The table of them drives validation and `--help_config`.
struct SchemaField {
  std::string path =
      {};  ///< "repeats", or "meshes.file" for a key of the entries of the list `meshes`
  FieldKind kind = FieldKind::kText;
  std::string help = {};
  std::string default_text = {};  ///< as it would be written; empty: none
  bool required = false;
  bool matrix = false;  ///< a list of values makes one run for each
  bool list = false;    ///< a list of values is one value; of sections: or one map is
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  std::vector<std::string> choices = {};  ///< the texts allowed; empty: any
  OptionInfo::Check check = {};           ///< of a text, further than `choices`; empty: none
  std::vector<std::string> former = {};   ///< names that the key had once
  std::map<std::string, std::string> former_choices = {};  ///< texts allowed once, as they are now
  std::string one_of = {};  ///< an entry has exactly one of the keys that name the same group
  std::vector<std::string> beside = {};  ///< may only stand beside one of these keys
  std::string brings = {};               ///< asks for this key beside it

  std::string Key() const;          ///< the last part of the path
  std::string_view Parent() const;  ///< the path without it
};

using Schema = std::vector<SchemaField>;

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

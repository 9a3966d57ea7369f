#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <yaml-cpp/yaml.h>

#include "experiments/run_experiment/config/config_text.h"
#include "experiments/run_experiment/config/planned_run.h"
#include "experiments/run_experiment/config/schema.h"

namespace cirque {

/// One key of an entry with the values given for it.
struct Axis {
  std::string key;
  std::vector<std::string> values;
};

/// One choice of a value on every axis.
struct Combination {
  struct Setting {
    std::string key, value;
    bool varies = false;  ///< whether the axis has several values
  };
  std::vector<Setting> settings;
};

/// The given matrix keys of an entry, in the order of the schema.
std::vector<Axis> AxesOf(const YAML::Node& entry, const Schema& schema, const std::string& path);

/// How many combinations the axes have; a double, because it may exceed any integer.
double CountCombinations(const std::vector<Axis>& axes);

/// Their cross product, the last axis fastest.
std::vector<Combination> Combine(const std::vector<Axis>& axes);

/// The meshes of a config and what there is to say about those that were skipped.
struct MeshEntries {
  std::vector<MeshSpec> meshes;
  std::vector<std::string> notes;
  bool some_skipped = false;  ///< whether there are meshes whose files do not exist
};

/// Turns the list `meshes` into surfaces: patterns and value lists are expanded, files and archive
/// members looked up, relative paths started at `root`. Entries that the schema refused are passed
/// over; everything found wrong here (no such file, no such member, two equal names) is reported.
/// Where there are `seeds`, generated meshes are made with each of them; of the others a note says
/// that nothing in them is random.
MeshEntries ResolveMeshes(const YAML::Node& list, const std::string& root,
                          const std::vector<std::string>& seeds, Diagnostics* problems);

/// The methods of a config, which the schema has let pass, their lists of values expanded.
/// Relative paths of files start at `root`. Reported: two equal names, a key that has no meaning for a
/// domain of the entry, options that do not go together, files that are not there.
std::vector<MethodSpec> ReadMethods(const YAML::Node& list, const std::string& root,
                                    Diagnostics* problems);

/// The list `figures` of a config, which the schema has let pass, as the report reads it from
/// figures.json: a list of objects with `kind`, `title`, `scale`, and `x`, `y`, `by` as objects of
/// `name`, `pointer` (into a record) and `label`. Reported: a y that is missing, or given to a
/// histogram; the same figure twice.
nlohmann::json ReadFigures(const YAML::Node& list, Diagnostics* problems);

}  // namespace cirque

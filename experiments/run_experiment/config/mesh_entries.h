#pragma once

#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "experiments/run_experiment/config/diagnostics.h"
#include "experiments/run_experiment/config/planned_run.h"

namespace cirque {

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

}  // namespace cirque

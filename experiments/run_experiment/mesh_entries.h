#pragma once

#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "experiments/run_experiment/cells.h"
#include "experiments/run_experiment/diagnostics.h"

namespace cirque {

/// The meshes of a config and what there is to say about those that were skipped.
struct MeshEntries {
  std::vector<MeshSpec> meshes;
  std::vector<std::string> notes;
};

/// Turns the list `meshes` into surfaces: patterns and value lists are expanded, files and archive
/// members looked up, relative paths started at `root`. Entries that the schema refused are passed
/// over; everything found wrong here (no such file, no such member, two equal names) is reported.
MeshEntries ResolveMeshes(const YAML::Node& list, const std::string& root, Diagnostics* problems);

}  // namespace cirque

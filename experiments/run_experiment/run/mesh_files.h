#pragma once

#include <string>
#include <vector>

#include "cirque/core/status.h"

#include "experiments/run_experiment/config/planned_run.h"

namespace cirque {

/// A surface as a run finds it.
struct LocatedMesh {
  std::string path;  ///< the file to read; empty for a generated mesh
  std::string hash;  ///< of the file's bytes, or of what the generator is asked for
};

/// Takes the members of archives out of them into `cache`, unless that was done before: every archive
/// is read once.
Status ExtractMembers(const std::vector<MeshSpec>& meshes, const std::string& cache);

/// Finds the mesh's file, taking it out of its archive into `cache` unless that was done before.
StatusOr<LocatedMesh> LocateMesh(const MeshSpec& mesh, const std::string& cache);

}  // namespace cirque

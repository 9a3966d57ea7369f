#pragma once

#include <string>

#include "cirque/core/status.h"

#include "experiments/run_experiment/config/planned_run.h"

namespace cirque {

/// A surface as a run finds it.
struct LocatedMesh {
  std::string path;  ///< the file to read; empty for a generated mesh
  std::string hash;  ///< of the file's bytes, or of what the generator is asked for
};

/// Finds the mesh's file, taking it out of its archive into `cache` unless that was done before.
StatusOr<LocatedMesh> LocateMesh(const MeshSpec& mesh, const std::string& cache);

}  // namespace cirque

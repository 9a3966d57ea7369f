#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cirque/core/status.h"

#include "experiments/run_experiment/config/planned_run.h"

namespace cirque {

/// What is known of a mesh before it is mapped: counts of its surfaces, after repair.
struct MeshFacts {
  double triangles = 0, vertices = 0;
  double components = 0;
  double genus = 0;  ///< of all components together
  double loops = 0;  ///< boundary loops
};

/// Their names, as conditions have them.
std::vector<std::string> FactNames();

/// Of which meshes something holds.
using MeshCondition = std::function<bool(const MeshFacts&)>;

/// Reads a condition: comparisons (== != < <= > >=) of facts and numbers, joined by `and`, `or`,
/// `not` and parentheses, as in "genus == 0 and (loops == 1 or triangles >= 1000)". Error (invalid
/// input): anything else; the message says where.
StatusOr<MeshCondition> ParseMeshCondition(const std::string& text);

/// The facts of a mesh as the file content says it. Error (invalid input): it is no surface, nor
/// several, after the repair.
StatusOr<MeshFacts> FactsOf(const MeshSpec& mesh, const std::string& content);

/// The meshes, of which none is generated, of which the condition holds, in their order. Reads every
/// file, an archive once. What is no surface is left out; `num_no_surface` counts it. Error (invalid
/// input): a file cannot be read.
StatusOr<std::vector<MeshSpec>> SelectMeshes(const std::vector<MeshSpec>& meshes,
                                             const MeshCondition& condition, int* num_no_surface);

}  // namespace cirque

#include "experiments/studies/studies.h"

#include <cstdio>

#include <fmt/format.h>
#include <gflags/gflags.h>

#include "cirque/core/atomic_file.h"

DEFINE_string(output, "", "file for what the study makes; tables go to standard output without it");

namespace cirque {

const std::vector<Study>& Studies() {
  static const std::vector<Study> kTable = {
      {"strategies", "[FLAGS] MESH ...",
       "Minimises every energy of each mesh, which is to be a disk, by every strategy, and\n"
       "compares Ceres on edge residuals with Newton and with Ceres on gradient residuals:\n"
       "the tables of results/strategies.md.",
       "experiments/studies/strategies.cc", RunStrategies},
      {"lorentz", "[FLAGS]",
       "Centres crowded points on the sphere by the re-centred Newton method, by Newton's method\n"
       "in ball coordinates and by its full steps: results/lorentz.md.",
       "experiments/studies/lorentz.cc", RunLorentz},
      {"disk_accuracy", "[FLAGS]",
       "Maps to the unit disk and to rectangles, refined, against what is known of them:\n"
       "results/disk_accuracy.md.",
       "experiments/studies/disk_accuracy.cc", RunDiskAccuracy},
      {"invariance", "[FLAGS]",
       "Maps rough patches as they are and renumbered, turned in space and scaled, and counts the\n"
       "maps that differ by more than a similarity.",
       "experiments/studies/invariance.cc", RunInvariance},
      {"random_surfaces", "[FLAGS]",
       "Maps random small surfaces, made to be hard, with random options, and has every map and\n"
       "every proof that there is none judged by the verifier: results/random_surfaces.md.",
       "experiments/studies/random_surfaces.cc", RunRandomSurfaces},
      {"any_cones", "[FLAGS]",
       "Maps random small surfaces with random cones that Gauss-Bonnet allows, by circle "
       "patterns,\n"
       "by the ladder and by conformal equivalence, and counts what is left without a map:\n"
       "results/any_cones.md.",
       "experiments/studies/any_cones.cc", RunAnyCones},
      {"moved_texture", "[FLAGS] MESH ...",
       "Bakes a smooth function for one map of each mesh, moves the texture to another map and\n"
       "holds it against the function baked there: results/moved_texture.md.",
       "experiments/studies/moved_texture.cc", RunMovedTexture},
      {"slim", "[FLAGS] MESH ...",
       "Maps disks with the least symmetric Dirichlet energy and again by SLIM, written for this\n"
       "comparison: results/slim.md.",
       "experiments/studies/slim.cc", RunSlim},
      {"reference_factorization", "[FLAGS] MESH ...",
       "Times one analysis and factorization of each mesh's V x V cotangent Laplacian, beside\n"
       "which the times of other programs and machines can be read. --output writes the mesh,\n"
       "split as asked.",
       "experiments/studies/reference_factorization.cc", RunReferenceFactorization},
      {"lower_bound", "--output=FILE MESH",
       "The lower bound of a circle pattern, as a process to be timed whole: reads the mesh,\n"
       "factors its F x F dual Laplacian once and writes it with texture coordinates, its x and y.",
       "experiments/studies/lower_bound.cc", RunLowerBound}};
  return kTable;
}

const std::string& OutputFile() { return FLAGS_output; }

Status Deliver(const std::string& text) {
  if (!FLAGS_output.empty()) return WriteFileAtomically(FLAGS_output, text);
  fmt::print("{}", text);
  return Status();
}

Status NoArguments(const StudyCall& call) {
  if (call.arguments.empty()) return Status();
  return Status::InvalidInput(
      fmt::format("unexpected argument '{}'; see --help", call.arguments.front()));
}

}  // namespace cirque

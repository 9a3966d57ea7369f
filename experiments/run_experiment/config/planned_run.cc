#include "experiments/run_experiment/config/planned_run.h"

#include <fnmatch.h>

#include <fmt/format.h>

namespace cirque {

std::string MeshSpec::Source() const {
  const std::string fineness =
      subdivisions == 0 ? "" : fmt::format(" subdivisions={}", subdivisions);
  if (!file.empty()) return file + fineness;
  if (!archive.empty()) return archive + ":" + member + fineness;
  return fmt::format("{} triangles={} seed={}{}{}", generator, generator_options.triangles,
                     generator_options.seed, known_boundary ? " boundary=known_map" : "", fineness);
}

std::string PlannedRun::Label() const {
  const std::string label = mesh.name + "/" + method.name;
  return repeat == 0 ? label : fmt::format("{}#{}", label, repeat + 1);
}

std::vector<PlannedRun> PlanRuns(const std::vector<MeshSpec>& meshes,
                                 const std::vector<MethodSpec>& methods, int repeats) {
  std::vector<PlannedRun> runs;
  for (const MeshSpec& mesh : meshes) {
    for (const MethodSpec& method : methods) {
      for (int repeat = 0; repeat < repeats; ++repeat) runs.push_back({mesh, method, repeat});
    }
  }
  return runs;
}

bool MatchesPattern(const PlannedRun& run, const std::string& pattern) {
  for (const std::string& label : {run.Label(), run.mesh.name + "/" + run.method.name}) {
    if (fnmatch(pattern.c_str(), label.c_str(), 0) == 0) return true;
  }
  return false;
}

std::vector<PlannedRun> SelectRuns(const std::vector<PlannedRun>& runs, const std::string& text) {
  const bool is_pattern = text.find_first_of("*?[") != std::string::npos;
  std::vector<PlannedRun> selected;
  for (const PlannedRun& run : runs) {
    if (is_pattern ? MatchesPattern(run, text) : run.Label().find(text) != std::string::npos) {
      selected.push_back(run);
    }
  }
  return selected;
}

}  // namespace cirque

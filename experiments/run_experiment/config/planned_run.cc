#include "experiments/run_experiment/config/planned_run.h"

#include <fnmatch.h>

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "experiments/run_experiment/config/config_text.h"
#include "experiments/run_experiment/config/file_content.h"

namespace cirque {

std::string MeshSpec::Source() const {
  std::string fineness = repair == MeshSpec().repair ? "" : " repair=" + repair;
  if (decimate > 0) fineness += fmt::format(" decimate={}", decimate);
  if (subdivisions > 0) {
    fineness += fmt::format(" subdivisions={}", subdivisions);
    if (subdivision != MeshSpec().subdivision) fineness += " subdivision=" + subdivision;
  }
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

namespace {

constexpr int kMaxShards = 100000;

}  // namespace

std::string Shard::FileName() const {
  if (IsWhole()) return "results.jsonl";
  return fmt::format("results.shard-{}-of-{}.jsonl", index, count);
}

StatusOr<Shard> ParseShard(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash != std::string::npos) {
    const auto index = ParseInteger(text.substr(0, slash));
    const auto count = ParseInteger(text.substr(slash + 1));
    if (index && count && *index >= 1 && *index <= *count && *count <= kMaxShards) {
      return Shard{static_cast<int>(*index), static_cast<int>(*count)};
    }
  }
  return Status::InvalidInput(fmt::format(
      "--shard={}: expected i/n with i from 1 to n, n at most {}, e.g. 2/8", text, kMaxShards));
}

std::vector<PlannedRun> SelectShard(const std::vector<PlannedRun>& runs, const Shard& shard) {
  std::vector<std::pair<std::string, std::size_t>> shuffled;
  for (std::size_t i = 0; i < runs.size(); ++i) shuffled.emplace_back(HashOf(runs[i].Label()), i);
  std::sort(shuffled.begin(), shuffled.end());
  std::vector<std::size_t> own;
  for (std::size_t i = shard.index - 1; i < shuffled.size(); i += shard.count) {
    own.push_back(shuffled[i].second);
  }
  std::sort(own.begin(), own.end());
  std::vector<PlannedRun> selected;
  for (const std::size_t i : own) selected.push_back(runs[i]);
  return selected;
}

}  // namespace cirque

#include "experiments/run_experiment/config/shard.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "experiments/run_experiment/config/content_hash.h"
#include "experiments/run_experiment/config/scalars.h"

namespace cirque {
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

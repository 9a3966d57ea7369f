#include <algorithm>

#include <fmt/format.h>

#include "experiments/run_experiment/config/config.h"
#include "experiments/run_experiment/config/config_text.h"

namespace cirque {
namespace {

constexpr const char* kPatterns[] = {"include", "exclude", "keep_maps"};
constexpr std::size_t kMostPatterns = 1000;  // each is held against every run

double NumberOrZero(const YAML::Node& value) {
  return value ? ParseNumber(value.Scalar()).value_or(0) : 0;
}

/// `true` and `false` stand for every run and none.
bool Names(const YAML::Node& item, const PlannedRun& run) {
  const std::string& text = item.Scalar();
  return ParseBoolean(text).value_or(MatchesPattern(run, text));
}

bool IsNamed(const std::vector<YAML::Node>& items, const PlannedRun& run) {
  return std::any_of(items.begin(), items.end(),
                     [&](const YAML::Node& item) { return Names(item, run); });
}

void CheckLengths(const YAML::Node& document, Diagnostics* problems) {
  for (const char* key : kPatterns) {
    if (ItemsOf(document[key]).size() <= kMostPatterns) continue;
    problems->Add(PlaceOf(document[key]),
                  fmt::format("'{}' lists more than {} patterns", key, kMostPatterns));
  }
}

void CheckPatterns(const YAML::Node& document, const std::vector<PlannedRun>& runs,
                   Diagnostics* problems) {
  for (const char* key : kPatterns) {
    for (const YAML::Node& item : ItemsOf(document[key])) {
      if (item.Scalar() == "false" ||
          std::any_of(runs.begin(), runs.end(),
                      [&](const PlannedRun& c) { return Names(item, c); })) {
        continue;
      }
      problems->Add(PlaceOf(item), fmt::format("'{}' names no run; --dry_run lists them, e.g. '{}'",
                                               item.Scalar(), runs.front().Label()));
    }
  }
}

}  // namespace

void ApplyRunSettings(const YAML::Node& document, bool some_skipped, Diagnostics* problems,
                      ExperimentConfig* config) {
  std::vector<PlannedRun>& runs = config->runs;
  CheckLengths(document, problems);
  if (problems->empty() && !some_skipped) CheckPatterns(document, runs, problems);
  if (!problems->empty()) return;
  const auto include = ItemsOf(document["include"]), exclude = ItemsOf(document["exclude"]);
  std::erase_if(runs, [&](const PlannedRun& run) {
    return (!include.empty() && !IsNamed(include, run)) || IsNamed(exclude, run);
  });
  if (runs.empty()) problems->Add({}, "nothing to run: include and exclude leave no run");
  const std::vector<std::string> measures = DistinctItems(document["measures"], problems);
  const RunLimits limits = {NumberOrZero(document["time_limit"]),
                            NumberOrZero(document["memory_limit"])};
  const auto keep = ItemsOf(document["keep_maps"]);
  const bool reference = TextOr(document, "reference", "false") == "true";
  const bool against_refined = TextOr(document, "against_refined", "false") == "true";
  for (PlannedRun& run : runs) {
    run.measures = measures;
    run.limits = limits;
    run.keep_map = IsNamed(keep, run);
    run.reference = reference;
    run.against_refined = against_refined;
  }
}

}  // namespace cirque

#include "experiments/run_experiment/config/run_settings.h"

#include <algorithm>

#include <fmt/format.h>

#include "experiments/run_experiment/config/scalars.h"

namespace cirque {
namespace {

std::vector<std::string> ReadMeasures(const YAML::Node& value, Diagnostics* problems) {
  std::vector<std::string> names;
  for (const YAML::Node& item : ItemsOf(value)) {
    if (std::find(names.begin(), names.end(), item.Scalar()) != names.end()) {
      problems->Add(PlaceOf(item), fmt::format("'{}' is listed twice", item.Scalar()));
    }
    names.push_back(item.Scalar());
  }
  return names;
}

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

void CheckPatterns(const YAML::Node& document, const std::vector<PlannedRun>& runs,
                   Diagnostics* problems) {
  for (const char* key : {"include", "exclude", "keep_maps"}) {
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

std::vector<YAML::Node> ItemsOf(const YAML::Node& value) {
  if (!value) return {};
  if (value.IsScalar()) return {value};
  return {value.begin(), value.end()};
}

void ApplyRunSettings(const YAML::Node& document, bool some_skipped, Diagnostics* problems,
                      ExperimentConfig* config) {
  std::vector<PlannedRun>& runs = config->runs;
  if (!some_skipped) CheckPatterns(document, runs, problems);
  if (!problems->empty()) return;
  const auto include = ItemsOf(document["include"]), exclude = ItemsOf(document["exclude"]);
  std::erase_if(runs, [&](const PlannedRun& run) {
    return (!include.empty() && !IsNamed(include, run)) || IsNamed(exclude, run);
  });
  if (runs.empty()) problems->Add({}, "nothing to run: include and exclude leave no run");
  const std::vector<std::string> measures = ReadMeasures(document["measures"], problems);
  const RunLimits limits = {NumberOrZero(document["time_limit"]),
                            NumberOrZero(document["memory_limit"])};
  const auto keep = ItemsOf(document["keep_maps"]);
  const bool reference = document["reference"] && document["reference"].Scalar() == "true";
  for (PlannedRun& run : runs) {
    run.measures = measures;
    run.limits = limits;
    run.keep_map = IsNamed(keep, run);
    run.reference = reference;
  }
}

}  // namespace cirque

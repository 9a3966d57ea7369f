#include "experiments/run_experiment/config/cell_settings.h"

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
bool Names(const YAML::Node& item, const Cell& cell) {
  const std::string& text = item.Scalar();
  return ParseBoolean(text).value_or(MatchesPattern(cell, text));
}

bool IsNamed(const std::vector<YAML::Node>& items, const Cell& cell) {
  return std::any_of(items.begin(), items.end(),
                     [&](const YAML::Node& item) { return Names(item, cell); });
}

void CheckPatterns(const YAML::Node& document, const std::vector<Cell>& cells,
                   Diagnostics* problems) {
  for (const char* key : {"include", "exclude", "keep_maps"}) {
    for (const YAML::Node& item : ItemsOf(document[key])) {
      if (item.Scalar() == "false" ||
          std::any_of(cells.begin(), cells.end(), [&](const Cell& c) { return Names(item, c); })) {
        continue;
      }
      problems->Add(PlaceOf(item), fmt::format("'{}' names no run; --dry_run lists them, e.g. '{}'",
                                               item.Scalar(), cells.front().Label()));
    }
  }
}

}  // namespace

std::vector<YAML::Node> ItemsOf(const YAML::Node& value) {
  if (!value) return {};
  if (value.IsScalar()) return {value};
  return {value.begin(), value.end()};
}

void ApplyCellSettings(const YAML::Node& document, bool some_skipped, Diagnostics* problems,
                       ExperimentConfig* config) {
  std::vector<Cell>& cells = config->cells;
  if (!some_skipped) CheckPatterns(document, cells, problems);
  if (!problems->empty()) return;
  const auto include = ItemsOf(document["include"]), exclude = ItemsOf(document["exclude"]);
  std::erase_if(cells, [&](const Cell& cell) {
    return (!include.empty() && !IsNamed(include, cell)) || IsNamed(exclude, cell);
  });
  if (cells.empty()) problems->Add({}, "nothing to run: include and exclude leave no run");
  const std::vector<std::string> measures = ReadMeasures(document["measures"], problems);
  const RunLimits limits = {NumberOrZero(document["time_limit"]),
                            NumberOrZero(document["memory_limit"])};
  const auto keep = ItemsOf(document["keep_maps"]);
  const bool reference = document["reference"] && document["reference"].Scalar() == "true";
  for (Cell& cell : cells) {
    cell.measures = measures;
    cell.limits = limits;
    cell.keep_map = IsNamed(keep, cell);
    cell.reference = reference;
  }
}

}  // namespace cirque

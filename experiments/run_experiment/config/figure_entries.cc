#include "experiments/run_experiment/config/figure_entries.h"

#include <set>

#include <fmt/format.h>

#include "experiments/run_experiment/config/quantities.h"

namespace cirque {
namespace {

nlohmann::json QuantityJson(const Quantity& quantity) {
  return {{"name", quantity.name}, {"pointer", quantity.pointer}, {"label", quantity.label}};
}

std::string TextOr(const YAML::Node& entry, const char* key, const std::string& otherwise) {
  const YAML::Node value = entry[key];
  return value ? value.Scalar() : otherwise;
}

/// Whether the figure has the axes that its kind needs.
bool CheckAxes(const YAML::Node& entry, const std::string& kind, Diagnostics* problems) {
  const bool counts = kind == "histogram";
  if (counts && entry["y"]) {
    problems->Add(PlaceOf(entry["y"]), "a histogram counts runs: leave out 'y'");
  } else if (!counts && !entry["y"]) {
    problems->Add(PlaceOf(entry), fmt::format("'{}' needs 'y'; only a histogram has none", kind));
  }
  return counts != static_cast<bool>(entry["y"]);
}

std::string TitleOf(const YAML::Node& entry, const Quantity& x, const std::string& by) {
  const std::string what =
      entry["y"] ? FindQuantity(Quantities(), entry["y"].Scalar()).label + " against " : "";
  return fmt::format("{}{}, by {}", what, x.label, by);
}

nlohmann::json ReadFigure(const YAML::Node& entry, const std::string& kind) {
  const Quantity& x = FindQuantity(Quantities(), entry["x"].Scalar());
  const Quantity& by = FindQuantity(Groups(), TextOr(entry, "by", "method"));
  nlohmann::json figure = {{"kind", kind},
                           {"scale", TextOr(entry, "scale", "linear")},
                           {"title", TextOr(entry, "title", TitleOf(entry, x, by.label))},
                           {"x", QuantityJson(x)},
                           {"by", QuantityJson(by)}};
  if (entry["y"]) figure["y"] = QuantityJson(FindQuantity(Quantities(), entry["y"].Scalar()));
  return figure;
}

}  // namespace

nlohmann::json ReadFigures(const YAML::Node& list, Diagnostics* problems) {
  nlohmann::json figures = nlohmann::json::array();
  std::set<nlohmann::json> seen;
  if (!list) return figures;
  for (const YAML::Node& entry : list) {
    const std::string kind = TextOr(entry, "kind", "scatter");
    if (!CheckAxes(entry, kind, problems)) continue;
    figures.push_back(ReadFigure(entry, kind));
    if (!seen.insert(figures.back()).second) {
      problems->Add(PlaceOf(entry), "this figure is listed twice");
    }
  }
  return figures;
}

}  // namespace cirque

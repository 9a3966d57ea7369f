#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "experiments/common/map_view/html.h"
#include "experiments/experiment_report/comparison.h"

namespace cirque::experiment_report {
namespace {

std::string NumberCell(double value, bool is_best = false) {
  if (!std::isfinite(value)) return "<td></td>";
  const char* css = is_best ? "number best" : "number";
  return fmt::format("<td class=\"{}\" data-value=\"{}\">{:.4g}</td>", css, value, value);
}

std::string Head(const std::vector<std::string>& names) {
  std::string html = "<thead><tr>";
  for (const std::string& name : names) {
    html += "<th scope=\"col\"><button type=\"button\">" + Escape(name) + "</button></th>";
  }
  return html + "</tr></thead>";
}

std::string ScoreRow(const MethodScore& score, int common) {
  const std::string interval =
      std::isfinite(score.ratio_high)
          ? fmt::format("{:.3g} to {:.3g}", score.ratio_low, score.ratio_high)
          : "";
  const std::string wins = score.contends ? fmt::format("{} of {}", score.wins, common) : "";
  return fmt::format(
      "<tr><td>{}</td><td class=\"number\" data-value=\"{}\">{}</td>{}<td class=\"number\" "
      "data-value=\"{}\">{}</td>{}<td class=\"number\">{}</td></tr>\n",
      Escape(score.method), score.maps, score.maps, NumberCell(score.median), score.wins, wins,
      NumberCell(score.ratio), interval);
}

std::string ScoreTable(const Comparison& of) {
  std::string html =
      "<div class=\"wide\"><table class=\"sortable\">" +
      Head({"method", "maps", "median", "best on", "over " + of.methods[0], "95 % of the median"}) +
      "<tbody>\n";
  for (const MethodScore& score : of.scores) html += ScoreRow(score, of.common);
  return html + "</tbody></table></div>\n";
}

std::string MeshTable(const Comparison& of) {
  std::vector<std::string> heads = {"mesh"};
  heads.insert(heads.end(), of.methods.begin(), of.methods.end());
  std::string html =
      "<details><summary>Mesh by mesh</summary><div class=\"wide\"><table "
      "class=\"sortable\">" +
      Head(heads) + "<tbody>\n";
  for (std::size_t i = 0; i < of.meshes.size(); ++i) {
    double least = INFINITY;
    for (const double value : of.value[i]) {
      if (std::isfinite(value)) least = std::min(least, value);
    }
    html += "<tr><td>" + Escape(of.meshes[i]) + "</td>";
    for (const double value : of.value[i]) html += NumberCell(value, value <= least);
    html += "</tr>\n";
  }
  return html + "</tbody></table></div></details>\n";
}

}  // namespace

std::string ComparisonsHtml(const std::vector<Comparison>& comparisons) {
  std::string html;
  for (const Comparison& comparison : comparisons) {
    html += "<h3>" + Escape(comparison.label) + "</h3>\n" + ScoreTable(comparison) +
            MeshTable(comparison);
  }
  return html;
}

}  // namespace cirque::experiment_report

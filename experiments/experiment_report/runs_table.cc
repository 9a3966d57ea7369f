#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "experiments/common/map_view/html.h"
#include "experiments/common/records.h"
#include "experiments/experiment_report/page.h"

namespace cirque::experiment_report {
namespace {

struct ShownColumn {
  std::string heading, pointer;
};

const std::vector<ShownColumn> kShownColumns = {
    {"mesh", "/mesh/name"},
    {"triangles", "/mesh/triangles"},
    {"method", "/method/name"},
    {"repeat", "/repeat"},
    {"outcome", "/outcome"},
    {"time [s]", "/seconds/total"},
    {"memory [MiB]", "/peak_memory_mib"},
    {"overlap", "/overlap"},
    {"qc mean", "/values/quasi_conformal_mean"},
    {"qc max", "/values/quasi_conformal_max"},
    {"log area rms", "/values/log_area_ratio_l2"},
    {"min theta", "/values/smallest_theta"},
    {"gradient", "/values/radii_gradient"},
    {"angle gap", "/values/angle_gap"},
    {"flips", "/values/flipped_triangles"},
};

std::set<std::string> Values(const std::vector<Run>& runs, const std::string& pointer) {
  std::set<std::string> values;
  for (const Run& run : runs) values.insert(TextAt(run.record, pointer));
  return values;
}

/// The columns above that say something, and those of the measures that runs were asked for.
std::vector<ShownColumn> Columns(const std::vector<Run>& runs) {
  std::vector<ShownColumn> columns;
  std::set<std::string> taken;
  for (const ShownColumn& column : kShownColumns) {
    taken.insert(column.pointer);
    const std::set<std::string> values = Values(runs, column.pointer);
    const bool says_nothing =
        values == std::set<std::string>{""} || (column.heading == "repeat" && values.size() == 1);
    if (!says_nothing) columns.push_back(column);
  }
  for (const Run& run : runs) {
    const nlohmann::json measures = run.record.value("measures", nlohmann::json::array());
    for (const nlohmann::json& measure : measures) {
      if (!measure.is_string()) continue;
      const std::string name = measure.get<std::string>();
      const std::string pointer = (nlohmann::json::json_pointer("/values") / name).to_string();
      if (taken.insert(pointer).second) columns.push_back({name, pointer});
    }
  }
  return columns;
}

std::string Cell(const Run& run, const ShownColumn& column, bool linked) {
  const double number = NumberAt(run.record, column.pointer);
  if (!std::isnan(number)) {
    return fmt::format("<td class=\"number\" data-value=\"{}\">{}</td>", number,
                       ShownNumber(number));
  }
  const std::string text = Escape(TextAt(run.record, column.pointer));
  if (column.heading == "outcome") {
    return fmt::format("<td><span class=\"verdict {0}\">{0}</span></td>", text);
  }
  if (column.heading == "mesh" && linked) {
    return fmt::format("<td><a href=\"#map-{}\">{}</a></td>", Escape(run.key), text);
  }
  return "<td>" + text + "</td>";
}

}  // namespace

std::string RunsHtml(const std::vector<Run>& runs, const std::vector<std::string>& shown_maps) {
  const std::vector<ShownColumn> columns = Columns(runs);
  std::string html = "<div class=\"wide\"><table class=\"sortable\" id=\"runs\"><thead><tr>";
  for (const ShownColumn& column : columns) {
    html += "<th scope=\"col\"><button>" + Escape(column.heading) + "</button></th>";
  }
  html += "</tr></thead><tbody>\n";
  for (const Run& run : runs) {
    const bool linked =
        std::find(shown_maps.begin(), shown_maps.end(), run.key) != shown_maps.end();
    html += "<tr id=\"run-" + Escape(run.key) + "\">";
    for (const ShownColumn& column : columns) html += Cell(run, column, linked);
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace cirque::experiment_report

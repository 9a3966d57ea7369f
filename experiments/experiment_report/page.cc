#include "experiments/experiment_report/page.h"

#include <cmath>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "experiments/common/map_view/html.h"
#include "experiments/common/map_view/map_payload.h"
#include "experiments/experiment_report/figures.h"

namespace cirque::experiment_report {
namespace {

std::string Section(const std::string& id, const std::string& heading, const std::string& body) {
  return fmt::format("<section id=\"{}\"><h2>{}</h2>\n{}</section>\n", id, heading, body);
}

std::string MapsHtml(const ShownMaps& maps) {
  std::string html;
  if (maps.keys.empty()) {
    html =
        "<p class=\"empty\">No run kept its map: <code>keep_maps: true</code> in the config "
        "makes runs keep theirs.</p>\n";
  } else {
    html = std::string(kViewerHtml);
  }
  for (const std::string& sentence : maps.left_out) {
    html += "<p class=\"note\">" + Escape(sentence) + "</p>\n";
  }
  return html;
}

std::string Navigation(bool comparison, bool failures) {
  std::string html = "<nav><a href=\"#summary\">Summary</a>";
  if (comparison) html += "<a href=\"#comparison\">Methods</a>";
  html += "<a href=\"#figures\">Figures</a><a href=\"#maps\">Maps</a><a href=\"#table\">Runs</a>";
  if (failures) html += "<a href=\"#failures\">Without a map</a>";
  return html + "</nav>\n";
}

std::string Body(const std::string& title, const Results& results, const ShownMaps& maps,
                 const std::vector<ConfigFigure>& figures) {
  const std::string failures = FailuresHtml(results.runs);
  const std::vector<Comparison> comparisons = CompareMethods(results.runs);
  std::string html = "<header><h1>" + Escape(title) + "</h1>" +
                     Navigation(!comparisons.empty(), !failures.empty()) + "</header>\n<main>\n";
  html += Section("summary", "Summary", SummaryHtml(results, comparisons));
  if (!comparisons.empty()) {
    html += Section("comparison", "Methods beside each other", ComparisonsHtml(comparisons));
  }
  html += Section("figures", "Figures",
                  "<div class=\"charts\">" + ConfigFiguresHtml(figures, results.runs) +
                      FiguresHtml(results.runs) + "</div>\n");
  html += Section("maps", "Maps", MapsHtml(maps));
  html += Section("table", "Runs", RunsHtml(results.runs, maps.keys));
  if (!failures.empty()) html += Section("failures", "Without a map", failures);
  return html + "</main>\n";
}

}  // namespace

void LinkRuns(const ShownMaps& maps, std::vector<Run>* runs) {
  const std::set<std::string> shown(maps.keys.begin(), maps.keys.end());
  for (Run& run : *runs) run.link = (shown.contains(run.key) ? "#map-" : "#run-") + run.key;
}

ShownMaps CollectMaps(const std::string& folder, const std::vector<Run>& runs,
                      std::size_t most_bytes) {
  ShownMaps maps;
  std::size_t bytes = 0;
  int too_many = 0;
  for (const Run& run : runs) {
    if (run.map.empty()) continue;
    if (too_many > 0) {  // maps are read only as long as there is room
      ++too_many;
      continue;
    }
    StatusOr<UvMap> map = ReadUvMap((std::filesystem::path(folder) / run.map).string());
    if (!map.ok()) {
      maps.left_out.push_back("Not shown: " + map.status().message());
      continue;
    }
    if (!std::isnan(run.Value("integer_gap"))) {
      map->lattice = LatticeOfOrder(static_cast<int>(run.Value("rotation_order")));
    }
    nlohmann::json view = MapPayload(*map);
    const std::size_t size = view["data"].get_ref<const std::string&>().size();
    if (bytes + size > most_bytes) {
      ++too_many;
      continue;
    }
    bytes += size;
    view.update({{"key", run.key}, {"mesh", run.mesh}, {"method", run.method}});
    maps.keys.push_back(run.key);
    maps.views.push_back(std::move(view));
  }
  if (too_many > 0) {
    maps.left_out.push_back(fmt::format(
        "Not shown for lack of room: {} more (experiment_report --max_megabytes=...).", too_many));
  }
  return maps;
}

std::string ReportHtml(const std::string& title, const Results& results, const ShownMaps& maps,
                       const std::vector<ConfigFigure>& figures) {
  std::vector<PageScript> scripts = {{"", kSaveFileScript}, {"", kTableScript}};
  if (!maps.keys.empty()) scripts.push_back({" type=\"module\"", kViewerScript});
  return PageHtml(title, Body(title, results, maps, figures),
                  {{"views", maps.views}, {"scales", ColourScales()}}, scripts);
}

}  // namespace cirque::experiment_report

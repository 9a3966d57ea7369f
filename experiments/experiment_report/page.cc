#include "experiments/experiment_report/page.h"

#include <filesystem>

#include <fmt/format.h>

#include "experiments/experiment_report/figures.h"
#include "experiments/experiment_report/html.h"
#include "experiments/experiment_report/map_payload.h"

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

std::string Navigation(bool failures) {
  std::string html =
      "<nav><a href=\"#summary\">Summary</a><a href=\"#figures\">Figures</a>"
      "<a href=\"#maps\">Maps</a><a href=\"#table\">Runs</a>";
  if (failures) html += "<a href=\"#failures\">Without a map</a>";
  return html + "</nav>\n";
}

std::string Script(const std::string& attributes, const std::string& content) {
  return "<script" + attributes + ">" + content + "</script>\n";
}

std::string Body(const std::string& title, const Results& results, const ShownMaps& maps,
                 const std::vector<ConfigFigure>& figures) {
  const std::string failures = FailuresHtml(results.runs);
  std::string html = "<header><h1>" + Escape(title) + "</h1>" + Navigation(!failures.empty()) +
                     "</header>\n<main>\n";
  html += Section("summary", "Summary", SummaryHtml(results));
  html += Section("figures", "Figures",
                  "<div class=\"charts\">" + ConfigFiguresHtml(figures, results.runs) +
                      FiguresHtml(results.runs) + "</div>\n");
  html += Section("maps", "Maps", MapsHtml(maps));
  html += Section("table", "Runs", RunsHtml(results.runs, maps.keys));
  if (!failures.empty()) html += Section("failures", "Without a map", failures);
  return html + "</main>\n";
}

}  // namespace

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
    const StatusOr<UvMap> map = ReadUvMap((std::filesystem::path(folder) / run.map).string());
    if (!map.ok()) {
      maps.left_out.push_back("Not shown: " + map.status().message());
      continue;
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
  const nlohmann::json data = {{"views", maps.views}, {"scales", ColourScales()}};
  const std::string json = data.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n";
  html +=
      "<title>" + Escape(title) + "</title>\n<style>" + std::string(kStyle) + "</style></head>\n";
  html += "<body>\n" + Body(title, results, maps, figures);
  html += Script(" type=\"application/json\" id=\"data\"", EscapeJson(json));
  html += Script("", std::string(kTableScript));
  if (!maps.keys.empty()) html += Script(" type=\"module\"", std::string(kViewerScript));
  return html + "</body></html>\n";
}

}  // namespace cirque::experiment_report

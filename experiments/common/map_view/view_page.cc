#include "experiments/common/map_view/view_page.h"

#include "experiments/common/map_view/html.h"
#include "experiments/common/map_view/map_payload.h"

namespace cirque {

std::string ViewPage(const std::string& title, const UvMap& map,
                     const std::vector<std::pair<std::string, std::string>>& facts) {
  std::string body = "<header><h1>" + Escape(title) + "</h1></header>\n<main id=\"maps\">\n";
  body += kViewerHtml;
  body += "<table class=\"facts\">\n";
  for (const auto& [name, value] : facts) {
    body += "<tr><th>" + Escape(name) + "</th><td>" + Escape(value) + "</td></tr>\n";
  }
  body += "</table>\n</main>\n";
  nlohmann::json view = MapPayload(map);
  view.update({{"key", "map"}, {"mesh", title}, {"method", ""}});
  return PageHtml(title, body, {{"views", {std::move(view)}}, {"scales", ColourScales()}},
                  {{" type=\"module\"", kViewerScript}});
}

}  // namespace cirque

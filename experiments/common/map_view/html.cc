#include "experiments/common/map_view/html.h"

#include <cmath>

#include <fmt/format.h>

#include "experiments/common/map_view/map_payload.h"
#include "experiments/common/map_view/sha256.h"

namespace cirque {

std::string Escape(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string EscapeJson(std::string_view json) {
  std::string escaped;
  for (const char c : json) escaped += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return escaped;
}

std::string ShownNumber(double value) {
  if (std::isnan(value)) return "";
  if (value == std::floor(value) && std::abs(value) < 1e9) return fmt::format("{:.0f}", value);
  return fmt::format("{:.4g}", value);
}

namespace {

/// What the page may do: run these scripts, draw, save pictures; it loads and sends nothing.
std::string ContentPolicy(const std::vector<PageScript>& scripts) {
  std::string allowed;
  for (const PageScript& script : scripts) {
    const auto digest = Sha256(script.text);
    allowed += " 'sha256-" + Base64({digest.begin(), digest.end()}) + "'";
  }
  return "default-src 'none'; script-src" + (allowed.empty() ? " 'none'" : allowed) +
         "; style-src 'unsafe-inline'; img-src data: blob:; base-uri 'none'; form-action 'none'";
}

}  // namespace

std::string PageHtml(const std::string& title, const std::string& body, const nlohmann::json& data,
                     const std::vector<PageScript>& scripts) {
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"" +
      ContentPolicy(scripts) +
      "\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n";
  html +=
      "<title>" + Escape(title) + "</title>\n<style>" + std::string(kStyle) + "</style></head>\n";
  html += "<body>\n" + body;
  const std::string json = data.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  html += "<script type=\"application/json\" id=\"data\">" + EscapeJson(json) + "</script>\n";
  for (const PageScript& script : scripts) {
    html += "<script" + script.attributes + ">";
    html += script.text;
    html += "</script>\n";
  }
  return html + "</body></html>\n";
}

}  // namespace cirque

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace cirque {

/// The text for use between tags and in quoted attributes.
std::string Escape(std::string_view text);

/// JSON for use inside a script element: no "<", so that nothing in it ends the element.
std::string EscapeJson(std::string_view json);

/// A number for people: four digits, or as many as an integer has; empty for NaN.
std::string ShownNumber(double value);

/// A script element of a page.
struct PageScript {
  std::string attributes;  ///< " type=\"module\"", or empty
  std::string_view text;
};

/// A document that needs nothing else: light or dark as the reader has it. `data` is for the element
/// "data", where scripts find it. A content-security policy lets these scripts run, by their digests,
/// and no other, and loads nothing from anywhere.
std::string PageHtml(const std::string& title, const std::string& body, const nlohmann::json& data,
                     const std::vector<PageScript>& scripts);

/// The files of assets/, embedded; the viewer's scripts one after the other.
extern const std::string_view kStyle;
extern const std::string_view kViewerHtml;
extern const std::string_view kViewerScript;
extern const std::string_view kSaveFileScript;

}  // namespace cirque

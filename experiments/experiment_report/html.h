#pragma once

#include <string>
#include <string_view>

namespace cirque::experiment_report {

/// The text for use between tags and in quoted attributes.
std::string Escape(std::string_view text);

/// JSON for use inside a script element: no "<", so that nothing in it ends the element.
std::string EscapeJson(std::string_view json);

/// A number for people: four digits, or as many as an integer has; empty for NaN.
std::string ShownNumber(double value);

/// The files of assets/, embedded by embed.cmake; the viewer's scripts one after the other.
extern const std::string_view kStyle;
extern const std::string_view kTableScript;
extern const std::string_view kViewerHtml;
extern const std::string_view kViewerScript;
extern const std::string_view kFiguresScript;  ///< Python

}  // namespace cirque::experiment_report

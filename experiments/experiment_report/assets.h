#pragma once

#include <string_view>

namespace cirque::experiment_report {

/// The files of assets/, embedded by embed.cmake; the viewer's scripts one after the other.
extern const std::string_view kStyle;
extern const std::string_view kTableScript;
extern const std::string_view kViewerHtml;
extern const std::string_view kViewerScript;
extern const std::string_view kFiguresScript;  ///< Python

}  // namespace cirque::experiment_report

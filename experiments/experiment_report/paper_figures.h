#pragma once

#include <string>

#include "cirque/core/status.h"

namespace cirque::experiment_report {

/// Has figures.py draw the tables as PDF files beside them, and says which. Error: no python3 or no
/// matplotlib, or what the script says.
Status DrawPaperFigures(const std::string& runs_json, const std::string& convergence_json,
                        const std::string& figures_json);

}  // namespace cirque::experiment_report

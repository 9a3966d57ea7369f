#pragma once

#include <string>
#include <vector>

#include "experiments/experiment_report/runs.h"

namespace cirque::experiment_report {

/// All charts of a study, one after the other as HTML: time against triangles, performance
/// profiles, distortion histograms, area against angle distortion, convergence of both solves.
std::string FiguresHtml(const std::vector<Run>& runs);

}  // namespace cirque::experiment_report

#pragma once

#include <string>
#include <vector>

#include "experiments/energy_strategies/study.h"

namespace cirque {

/// One Markdown table a mesh: a row an energy and method, with the reason where a method did not
/// converge.
std::string StrategyTables(const std::vector<Trial>& trials);

/// One Markdown table of all meshes, of the comparison of least-squares forms.
std::string LeastSquaresTable(const std::vector<Trial>& trials);

/// All that is known of every trial: {"strategies": [...], "least_squares": [...]}.
std::string ToJson(const std::vector<Trial>& strategies, const std::vector<Trial>& least_squares);

}  // namespace cirque

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cirque/core/solve_summary.h"

namespace cirque {

/// What became of an EnergyTrial.
struct EnergyOutcome {
  SolveSummary solve;
  int parameters = 0;
  double difference = kUnset;  ///< max norm, of comparable solutions, from newton's
};

/// A figure of every EnergyTrial: a column of the results and a quantity of figures.
struct EnergyFigure {
  std::string name, label;
  std::function<double(const EnergyOutcome&)> of;
};

/// The table of them.
const std::vector<EnergyFigure>& EnergyFigures();

}  // namespace cirque

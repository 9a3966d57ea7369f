#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cirque/core/solve_summary.h"
#include "cirque/solver/solver_strategy.h"

#include "experiments/common/solver_problem.h"

namespace cirque {

/// One solve of the study.
struct Trial {
  std::string mesh;
  int triangles = 0, parameters = 0;
  std::string energy, method;
  SolveSummary solve;
  double cpu_seconds = 0;      ///< of all threads: unlike wall time, the same on a busy machine
  double difference = kUnset;  ///< max norm, of comparable solutions, from newton's
};

/// A strategy with options, under the name that tables give it.
struct Method {
  std::string name, strategy;
  OptionMap options;
};

/// How long a solve may take [s].
struct TimeLimits {
  double first_order = 3;  ///< without Hessians, which takes thousands of iterations
  double other = 60;
};

/// Every strategy, newton first.
std::vector<Method> AllMethods(const TimeLimits& limits);

/// Newton, Ceres on exact residuals, Ceres on gradient residuals.
std::vector<Method> LeastSquaresMethods(const TimeLimits& limits);

/// Told after every trial.
using TrialCallback = std::function<void(const Trial&)>;

/// Minimises the energy by each method, newton first, and compares with newton's minimiser.
std::vector<Trial> CompareMethods(const StudyProblem& problem, const std::string& energy,
                                  const std::vector<Method>& methods, const SolveControl& control,
                                  const TrialCallback& told);

/// One Markdown table a mesh: a row an energy and method, with the reason where a method did not
/// converge.
std::string StrategyTables(const std::vector<Trial>& trials);

/// One Markdown table of all meshes, of the comparison of least-squares forms.
std::string LeastSquaresTable(const std::vector<Trial>& trials);

/// All that is known of every trial: {"strategies": [...], "least_squares": [...]}.
std::string ToJson(const std::vector<Trial>& strategies, const std::vector<Trial>& least_squares);

}  // namespace cirque

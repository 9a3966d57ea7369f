#pragma once

#include <string>

namespace cirque {

/// How to parameterize. Every field has a flag of circle_patterns and a key of an experiment config
/// by its name.
struct ParameterizeOptions {
  std::string triangulation = "delaunay";  ///< "delaunay": intrinsic Delaunay flips; "input": none
  std::string angle_fit = "quadratic";     ///< a name of AngleObjectives()
  std::string angle_strategy = "auto";     ///< a name of AngleStrategyNames()
  std::string strategy = "auto";           ///< a name of SolverStrategies(), for the log radii
  std::string layout = "directions";       ///< or "least_squares" (Poisson)
  double epsilon = 1e-3;     ///< least corner and intersection angle [rad]; shrinks where it must
  int max_iterations = 100;  ///< of each solve
};

}  // namespace cirque

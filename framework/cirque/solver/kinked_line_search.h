#pragma once

#include "cirque/solver/kinks.h"
#include "cirque/solver/line_search.h"

namespace cirque {

/// Searches from x along the path x + t p whose parameters stop at their kinks, on the energy of
/// `run`. The path bends where a parameter stops, so slopes along p do not tell how the energy fell
/// as in SearchAlong; a point y is accepted when
///   E(y) <= E(x) + 1e-4 g.(y - x)                     (Armijo), or
///   E(y) <= E(x) up to rounding and |g(y)| <= 0.9 |g(x)|,
/// g the subgradients of least norm. Steps are cut to a quarter. The memory of `result` is used
/// again. @pre g(x).p < 0.
void SearchAlongKinks(const Kinks& kinks, const Eigen::VectorXd& x,
                      const Eigen::VectorXd& subgradient, const Eigen::VectorXd& direction,
                      SolveRun* run, LineSearchResult* result);

}  // namespace cirque

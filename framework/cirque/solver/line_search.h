#pragma once

#include <Eigen/Core>

#include "cirque/solver/solve_run.h"

namespace cirque {

/// Where a line search ended; not found: nowhere better.
struct LineSearchResult {
  bool found = false;
  double step_length = 0;
  Eigen::VectorXd x, gradient;  ///< at the accepted point
};

/// Searches along p from x on the convex energy of `run`, by directional derivatives alone: energy
/// values lose half their digits near a minimum (and are dear), derivatives do not. A point is
/// accepted when
///   g(t).p <= 0                                  (by convexity the energy fell all the way), or
///   g(t).p <= 1/2 |g(0).p| and |g(t)| <= 0.9 |g(0)|   (overshot, but clearly nearer to the
///   minimum).
/// A step after which the slope hardly changed is doubled; one that overshot is cut by safeguarded
/// secants; one that left the domain is halved. The memory of `result` is used again.
/// @pre g(0).p < 0.
void SearchAlong(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient,
                 const Eigen::VectorXd& direction, SolveRun* run, LineSearchResult* result);

/// Searches along p from x for where the slope is at most a tenth of what it was, however far that is,
/// or as near to it as doubles tell: for energies that are all but linear between creases much
/// narrower than steps, on which each further step keeps to those that were found. Longer steps are
/// tried fourfold; between two whose slopes differ in sign it halves, first their exponents. The
/// memory of `result` is used again. @pre g(0).p < 0.
void SearchToRest(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient,
                  const Eigen::VectorXd& direction, SolveRun* run, LineSearchResult* result);

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

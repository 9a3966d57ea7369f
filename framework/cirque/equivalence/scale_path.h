#pragma once

#include <Eigen/Core>

#include "cirque/equivalence/scaled_metric.h"
#include "cirque/solver/solver_strategy.h"

namespace cirque {

/// What leads from a problem that is easy to the one that is asked.
enum class ScalePath {
  kFromZero,  ///< nothing: from no scales at all
  kTargets,   ///< angle sums on a straight line from the surface's own to the targets
  kLengths    ///< with the targets, lengths to a power from 0, where they are all alike, to 1
};

/// Leads the scales from 0 along a path of problems whose solutions change smoothly: where scales are as
/// large as a hundred, E is all but linear between narrow creases, and Newton's method from afar leaps
/// to and fro across them. Every step begins where the last two point. False: it did not get there.
bool FollowScalePath(const ScaleProblem& problem, ScalePath path, const SolveControl& control,
                     VertexScales* scales);

/// By MinimizeByLaplacians where no weight of the Hessian is below 0 (where the metric is Delaunay
/// throughout, beside no edge that is kept) and it has few unknowns, else by Newton's method.
SolveSummary MinimizeScalesRobustly(const ConformalEquivalenceEnergy& energy, bool is_closed,
                                    const SolverLimits& limits, const SolveControl& control,
                                    Eigen::VectorXd* u);

/// Adds `by` (V) to the scales.
void AdvanceScales(const Eigen::VectorXd& by, VertexScales* scales);

/// How many iterations at a time are made where u is counted anew after each; a part is idle that
/// leaves more of the residual than kLessResidual.
inline constexpr int kScaleIterationsInPart = 3;
inline constexpr double kLessResidual = 0.9;
inline constexpr double kNearScaleResidual = 1e-6;  ///< [rad]: the solution, but for rounding

}  // namespace cirque

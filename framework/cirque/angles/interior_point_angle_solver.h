#pragma once

#include <memory>
#include <string>

#include "cirque/angles/angle_fit.h"
#include "cirque/core/option_table.h"
#include "cirque/linear/registry.h"

namespace cirque {

struct InteriorPointOptions {
  int max_iterations = 100;
  double gap_tolerance = 1e-15;  ///< largest sum of multiplier * slack, relative to 1 + |objective|
  /// Largest residual of sums [rad], and relative one of stationarity.
  double feasibility_tolerance = 1e-11;
  double max_seconds = 1e9;
  std::string linear_solver;  ///< a name of LinearSolvers(); empty: its first
};

const OptionTable<InteriorPointOptions>& InteriorPointOptionTable();

/// Primal-dual interior point with Mehrotra's predictor and corrector for objectives of corner
/// angles only, of second derivative w (all but `barrier`). With slacks s = G x - h and their
/// multipliers z, D = diag(w) + G' diag(z / s) G is block diagonal by edges, so that each step's
/// linear system reduces by hand to B D^-1 B' in the multipliers y: as sparse as the dual's
/// Hessian, positive definite, factored once a step. Ranged vertex sums are variables of their own.
/// The callback gets the angles. Source: S. Mehrotra, On the implementation of a primal-dual
/// interior point method, SIAM J. Optim. 2 (1992); Nocedal & Wright, Numerical Optimization,
/// algorithm 16.4.
class InteriorPointAngleSolver final : public AngleSolver {
 public:
  explicit InteriorPointAngleSolver(const InteriorPointOptions& options) : options_(options) {}
  Status Fit(const AngleFitProblem& problem, const std::shared_ptr<const AngleObjective>& objective,
             const SolveControl& control, AngleFitResult* result) const override;

 private:
  InteriorPointOptions options_;
};

}  // namespace cirque

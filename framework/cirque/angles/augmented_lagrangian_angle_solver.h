#pragma once

#include <memory>

#include <Eigen/Core>
#include <ceres/problem.h>

#include "cirque/angles/angle_fit.h"
#include "cirque/core/option_table.h"
#include "cirque/energy/angle_objective.h"

namespace cirque {

struct AugmentedLagrangianOptions {
  int max_iterations = 1000;      ///< accepted inner steps, in all
  int max_outer_iterations = 60;  ///< updates of the multipliers
  double first_penalty = 1e3;     ///< rho, relative to the objective's mean curvature
  double penalty_growth = 10;     ///< of rho where the residual did not fall to a quarter
  double largest_penalty = 1e7;   ///< of rho, relative as the first
  double sum_tolerance = 1e-11;   ///< largest residual of sums [rad]
  double max_seconds = 1e9;       ///< wall clock; kNotConverged then
};

const OptionTable<AugmentedLagrangianOptions>& AugmentedLagrangianOptionTable();

/// Augmented Lagrangian on Ceres residual blocks, for every objective: ceres::Solve (Gauss-Newton
/// with a trust region, sparse normal Cholesky) minimises objective and penalties at fixed
/// multipliers (AddAngleResiduals), an outer loop updates them by
///   y        -= rho (A alpha - b)
///   of_lower  = max(0, of_lower + rho (m - alpha))
///   of_sums   = max(0, of_sums + rho (alpha_l + alpha_r - (pi - m))).
/// The callback gets the angles.
/// Source: Nocedal & Wright, Numerical Optimization, section 17.4.
class AugmentedLagrangianAngleSolver final : public AngleSolver {
 public:
  explicit AugmentedLagrangianAngleSolver(const AugmentedLagrangianOptions& options)
      : options_(options) {}
  Status Fit(const AngleFitProblem& problem, const std::shared_ptr<const AngleObjective>& objective,
             const SolveControl& control, AngleFitResult* result) const override;

 private:
  AugmentedLagrangianOptions options_;
};

/// What the augmented Lagrangian's residual blocks read at every evaluation, and its outer loop
/// changes in between.
struct AugmentedState {
  double penalty = 0;        ///< rho
  Eigen::VectorXd y;         ///< multipliers of A alpha = b, one a row
  Eigen::VectorXd of_lower;  ///< multipliers of alpha >= m, one a corner, >= 0
  Eigen::VectorXd of_sums;   ///< multipliers of alpha_l + alpha_r <= pi - m (boundary: of
                             ///< alpha <= pi - m), one an edge, >= 0
};

/// Distance of v from [lower, upper], negative below it.
double SignedDistance(double v, double lower, double upper);

/// Adds, on the scalar parameter blocks alpha[0 .. 3F - 1], residual blocks with analytic Jacobians
/// whose squares sum to twice
///   phi(alpha) + rho/2 sum_rows SignedDistance(A alpha - y / rho; lower, upper)^2
///              + rho/2 sum_corners max(0, m - alpha + of_lower / rho)^2
///              + rho/2 sum_edges max(0, alpha_l + alpha_r - (pi - m) + of_sums / rho)^2,
/// the last two only for margins m > 0: objectives with m = 0 keep their domain by refusing to be
/// evaluated outside, without inequalities (m < 0) there are none. (Ceres's own parameter bounds
/// project Gauss-Newton steps that know nothing of them: on an infeasible fit the inner solves then
/// stall before the multipliers show it.) `problem` owns the blocks; `fit`, `objective` and `state`
/// must outlive it.
void AddAngleResiduals(const AngleFitProblem& fit, const AngleObjective& objective,
                       const AugmentedState& state, double* alpha, ceres::Problem* problem);

}  // namespace cirque

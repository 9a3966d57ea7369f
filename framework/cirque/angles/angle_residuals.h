#pragma once

#include <Eigen/Core>
#include <ceres/problem.h>

#include "cirque/angles/angle_fit_problem.h"
#include "cirque/energy/angle_objective.h"

namespace cirque {

/// What the augmented Lagrangian's residual blocks read at every evaluation, and its outer loop
/// changes in between.
struct AugmentedState {
  double penalty = 0;        ///< rho
  Eigen::VectorXd y;         ///< multipliers of A alpha = b, one a row
  Eigen::VectorXd of_lower;  ///< multipliers of alpha >= m, one a corner, >= 0
  Eigen::VectorXd of_sums;   ///< multipliers of alpha_l + alpha_r <= pi - m (boundary: of alpha <=
                             ///< pi - m), one an edge, >= 0
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

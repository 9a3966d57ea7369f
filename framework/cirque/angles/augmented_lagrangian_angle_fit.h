#pragma once

#include <memory>

#include "cirque/angles/angle_fit.h"
#include "cirque/core/option_table.h"

namespace cirque {

struct AugmentedLagrangianOptions {
  int max_iterations = 1000;      ///< accepted inner steps, in all
  int max_outer_iterations = 60;  ///< updates of the multipliers
  double first_penalty = 1e3;     ///< rho, relative to the objective's mean curvature
  double penalty_growth = 10;     ///< of rho where the residual did not fall to a quarter
  double largest_penalty = 1e7;   ///< of rho, relative as the first
  double sum_tolerance = 1e-11;   ///< largest residual of sums [rad]
  double max_seconds = 1e9;
};

const OptionTable<AugmentedLagrangianOptions>& AugmentedLagrangianOptionTable();

/// Augmented Lagrangian on Ceres residual blocks, for every objective: ceres::Solve (Gauss-Newton
/// with a trust region, sparse normal Cholesky) minimises objective and penalties at fixed
/// multipliers (AddAngleResiduals), an outer loop updates them by
///   y -= rho (A alpha - b),   of_lower = max(0, of_lower + rho (m - alpha)),
///   of_sums = max(0, of_sums + rho (alpha_l + alpha_r - (pi - m))).
/// The callback gets the angles.
/// Source: Nocedal & Wright, Numerical Optimization, section 17.4.
class AugmentedLagrangianAngleFit final : public AngleFitMethod {
 public:
  explicit AugmentedLagrangianAngleFit(const AugmentedLagrangianOptions& options)
      : options_(options) {}
  Status Fit(const AngleFitProblem& problem, const std::shared_ptr<const AngleObjective>& objective,
             const SolveControl& control, AngleFitResult* result) const override;

 private:
  AugmentedLagrangianOptions options_;
};

}  // namespace cirque

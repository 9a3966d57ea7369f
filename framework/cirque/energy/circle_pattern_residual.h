#pragma once

#include <ceres/sized_cost_function.h>

namespace cirque {

/// The exact least-squares form of one interior edge of a circle pattern, in the two log radii
/// beside it:
///   r(rho_i, rho_j) = sign(d - d_e) sqrt(2 (psi_e(d) - psi_e(d_e))),   d = rho_i - rho_j,
/// psi_e' = 2 (alpha_i - phi_i(d)), d_e = log(sin alpha_j / sin alpha_i). Smooth, also at d_e.
/// jacobians[0][0] = dr/dd = -jacobians[1][0].
class CirclePatternResidual final : public ceres::SizedCostFunction<1, 1, 1> {
 public:
  CirclePatternResidual(double alpha_i, double alpha_j) : alpha_i_(alpha_i), alpha_j_(alpha_j) {}

  bool Evaluate(double const* const* rho, double* residual, double** jacobians) const override;

 private:
  double alpha_i_, alpha_j_;  ///< coherent corner angles opposite the edge [rad]
};

}  // namespace cirque

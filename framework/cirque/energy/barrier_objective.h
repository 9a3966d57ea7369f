#pragma once

#include "cirque/energy/angle_objective.h"

namespace cirque {

/// The thesis's nonlinear energy: the Itakura-Saito divergence delta(x; x0) = IS(x / x0) of corner
/// and of intersection angles. It is its own barrier: Q_e is the open triangle of positive angles.
/// References are clamped to >= eps, since theta0 <= 0 at an edge that is not Delaunay has no
/// divergence.
///
/// Conjugate: with p = 1/ref_l - 1/theta0 - s_l, q likewise, u = 1/theta solves 1/u + 1/(u + p) +
/// 1/(u + q) = pi by a monotone Newton iteration; alpha_l = 1/(u + p), alpha_r = 1/(u + q).
class BarrierObjective final : public AngleObjective {
 public:
  ScalarJet Distance(double reference, double x) const override;
  ResidualJet Residual(double reference, double x) const override;
  bool MeasuresTheta() const override { return true; }
  double ClampReference(double reference, double epsilon) const override;
  double Margin(double) const override { return 0; }
  EdgeConjugate InteriorConjugate(double ref_l, double ref_r, double epsilon, double s_l,
                                  double s_r) const override;
  EdgeConjugate BoundaryConjugate(double ref, double epsilon, double s) const override;
};

}  // namespace cirque

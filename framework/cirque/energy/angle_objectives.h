#pragma once

#include "cirque/energy/angle_objective.h"
#include "cirque/energy/separable_objective.h"

namespace cirque {

/// delta(x; x0) = w/2 (x - x0)^2.
///   kUniform    w = 1: the thesis's quadratic program
///   kRelative   w = 1 / x0^2, x0 clamped to >= eps: the weights of angle-based flattening
///               (Sheffer & de Sturler 2001)
///   kUnbounded  w = 1 without inequalities (Q_e is everything): the linear least-squares
///               projection
class QuadraticObjective final : public SeparableObjective<QuadraticObjective> {
 public:
  enum class Kind { kUniform, kRelative, kUnbounded };

  explicit QuadraticObjective(Kind kind) : kind_(kind) {}

  ScalarJet Distance(double reference, double x) const override;
  ResidualJet Residual(double reference, double x) const override;
  double WithSlope(double reference, double slope) const;
  double ClampReference(double reference, double epsilon) const override;
  double Margin(double epsilon) const override;

 private:
  double Weight(double reference) const;

  Kind kind_;
};

/// delta(x; x0) = x log(x / x0) - x + x0: the Kullback-Leibler divergence of the angles from their
/// references, which are clamped to what is the least margin of a corner.
///
/// Conjugate, in closed form: with f = x0 e^s, alpha = f or its margin on both sides of the edge, of
/// value alpha - x0 and curvature 1 / alpha where free. Where the two exceed S, pi less the margin
/// of theta, they share it as the f do: alpha_l = S f_l / (f_l + f_r), of value
/// S log((f_l + f_r) / S) + S - x0_l - x0_r for both, until one of them is at its margin.
class EntropyObjective final : public AngleObjective {
 public:
  ScalarJet Distance(double reference, double x) const override;
  ResidualJet Residual(double reference, double x) const override;
  double ClampReference(double reference, double epsilon) const override;
  EdgeConjugate InteriorConjugate(double ref_l, double ref_r, double epsilon, double s_l,
                                  double s_r) const override;
  EdgeConjugate BoundaryConjugate(double ref, double epsilon, double s) const override;
};

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

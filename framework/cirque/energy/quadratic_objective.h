#pragma once

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

}  // namespace cirque

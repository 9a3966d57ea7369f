#pragma once

#include "cirque/energy/separable_objective.h"

namespace cirque {

/// delta(x; x0) = x log(x / x0) - x + x0: the Kullback-Leibler divergence of the angles from their
/// references, which are clamped to >= eps.
class EntropyObjective final : public SeparableObjective<EntropyObjective> {
 public:
  ScalarJet Distance(double reference, double x) const override;
  ResidualJet Residual(double reference, double x) const override;
  double WithSlope(double reference, double slope) const;
  double ClampReference(double reference, double epsilon) const override;
};

}  // namespace cirque

#pragma once

#include "cirque/energy/separable_objective.h"

namespace cirque {

/// The example of framework/docs/adding-an-energy.md: delta(x; x0) = cosh(x - x0) - 1.
class CoshObjective final : public SeparableObjective<CoshObjective> {
 public:
  ScalarJet Distance(double reference, double x) const override;
  ResidualJet Residual(double reference, double x) const override;
  double WithSlope(double reference, double slope) const;
};

}  // namespace cirque

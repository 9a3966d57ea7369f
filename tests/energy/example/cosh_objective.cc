#include "tests/energy/example/cosh_objective.h"

#include <cmath>

namespace cirque {

ScalarJet CoshObjective::Distance(double reference, double x) const {
  const double half = std::sinh(0.5 * (x - reference));
  return {2 * half * half, std::sinh(x - reference), std::cosh(x - reference)};
}

ResidualJet CoshObjective::Residual(double reference, double x) const {
  const double half = 0.5 * (x - reference);
  return {2 * std::sinh(half), std::cosh(half)};
}

double CoshObjective::WithSlope(double reference, double slope) const {
  return reference + std::asinh(slope);
}

}  // namespace cirque

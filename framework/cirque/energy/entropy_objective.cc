#include "cirque/energy/entropy_objective.h"

#include <algorithm>
#include <cmath>

#include "cirque/math/itakura_saito.h"

namespace cirque {

ScalarJet EntropyObjective::Distance(double reference, double x) const {
  const ScalarJet kl = KullbackLeibler(x / reference);
  return {reference * kl.value, kl.slope, kl.curvature / reference};
}

ResidualJet EntropyObjective::Residual(double reference, double x) const {
  const ResidualJet r = KullbackLeiblerResidual(x / reference);
  const double root = std::sqrt(reference);
  return {root * r.value, r.slope / root};
}

double EntropyObjective::WithSlope(double reference, double slope) const {
  return reference * std::exp(slope);
}

double EntropyObjective::ClampReference(double reference, double epsilon) const {
  return std::max(reference, epsilon);
}

}  // namespace cirque

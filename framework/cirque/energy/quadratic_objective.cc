#include "cirque/energy/quadratic_objective.h"

#include <algorithm>
#include <cmath>

namespace cirque {

double QuadraticObjective::Weight(double reference) const {
  return kind_ == Kind::kRelative ? 1 / (reference * reference) : 1;
}

ScalarJet QuadraticObjective::Distance(double reference, double x) const {
  const double w = Weight(reference), difference = x - reference;
  return {0.5 * w * difference * difference, w * difference, w};
}

ResidualJet QuadraticObjective::Residual(double reference, double x) const {
  const double root = std::sqrt(Weight(reference));
  return {root * (x - reference), root};
}

double QuadraticObjective::WithSlope(double reference, double slope) const {
  return reference + slope / Weight(reference);
}

double QuadraticObjective::ClampReference(double reference, double epsilon) const {
  return kind_ == Kind::kRelative ? std::max(reference, epsilon) : reference;
}

double QuadraticObjective::Margin(double epsilon) const {
  return kind_ == Kind::kUnbounded ? -1 : epsilon;
}

}  // namespace cirque

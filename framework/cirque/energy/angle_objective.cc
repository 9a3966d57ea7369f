#include "cirque/energy/angle_objective.h"

#include "cirque/core/types.h"

namespace cirque {

double AngleObjective::Interior(double ref_l, double ref_r, double epsilon, double alpha_l,
                                double alpha_r) const {
  const auto distance = [&](double ref, double x) {
    return Distance(ClampReference(ref, epsilon), x).value;
  };
  const double corners = distance(ref_l, alpha_l) + distance(ref_r, alpha_r);
  return MeasuresTheta() ? corners + distance(kPi - ref_l - ref_r, kPi - alpha_l - alpha_r)
                         : corners;
}

double AngleObjective::Boundary(double ref, double epsilon, double alpha) const {
  const auto distance = [&](double r, double x) {
    return Distance(ClampReference(r, epsilon), x).value;
  };
  return MeasuresTheta() ? distance(ref, alpha) + distance(kPi - ref, kPi - alpha)
                         : distance(ref, alpha);
}

}  // namespace cirque

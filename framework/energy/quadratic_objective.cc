#include "cirque/energy/quadratic_objective.h"

#include <algorithm>

#include "cirque/core/types.h"

namespace cirque {
namespace {

double HalfSquare(double x) { return 0.5 * x * x; }

/// Projects (c_l, c_r) onto Q_e and differentiates the projection.
EdgeConjugate ProjectOntoTriangle(double c_l, double c_r, double eps) {
  const double most = kPi - eps;
  EdgeConjugate p;
  p.alpha_l = std::max(c_l, eps);
  p.alpha_r = std::max(c_r, eps);
  p.h_ll = c_l > eps ? 1 : 0;
  p.h_rr = c_r > eps ? 1 : 0;
  if (p.alpha_l + p.alpha_r <= most) return p;
  const double excess = 0.5 * (c_l + c_r - most);
  p.alpha_l = std::clamp(c_l - excess, eps, most - eps);
  p.alpha_r = most - p.alpha_l;
  const bool on_segment = c_l - excess > eps && c_r - excess > eps;
  p.h_ll = p.h_rr = on_segment ? 0.5 : 0;
  p.h_lr = on_segment ? -0.5 : 0;
  return p;
}

}  // namespace

double QuadraticObjective::Interior(double ref_l, double ref_r, double alpha_l,
                                    double alpha_r) const {
  return HalfSquare(alpha_l - ref_l) + HalfSquare(alpha_r - ref_r);
}

double QuadraticObjective::Boundary(double ref, double alpha) const {
  return HalfSquare(alpha - ref);
}

EdgeConjugate QuadraticObjective::InteriorConjugate(double ref_l, double ref_r, double eps,
                                                    double s_l, double s_r) const {
  EdgeConjugate g = ProjectOntoTriangle(ref_l + s_l, ref_r + s_r, eps);
  g.value = s_l * g.alpha_l + s_r * g.alpha_r - Interior(ref_l, ref_r, g.alpha_l, g.alpha_r);
  return g;
}

EdgeConjugate QuadraticObjective::BoundaryConjugate(double ref, double eps, double s) const {
  EdgeConjugate g;
  const double c = ref + s;
  g.alpha_l = std::clamp(c, eps, kPi - eps);
  g.h_ll = c > eps && c < kPi - eps ? 1 : 0;
  g.value = s * g.alpha_l - Boundary(ref, g.alpha_l);
  return g;
}

}  // namespace cirque

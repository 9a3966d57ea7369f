#include "cirque/energy/separable_objective.h"

#include <algorithm>
#include <cmath>

#include "cirque/core/types.h"

namespace cirque {
namespace {

constexpr int kMaxNewtonSteps = 100;

}  // namespace

/// Maximises s.a - phi(a) over a_l + a_r = pi - eps, both >= eps. With a_l = x: the slope's
/// difference (s_l - delta'(x)) - (s_r - delta'(m - x)) decreases in x.
EdgeConjugate SeparableObjective::MaximiseOnSum(double ref_l, double ref_r, double eps, double s_l,
                                                double s_r) const {
  const double sum = kPi - eps;
  double low = eps, high = sum - eps, x = 0.5 * sum;
  const auto excess = [&](double at, double* curvature) {
    const ScalarJet l = Distance(ref_l, at), r = Distance(ref_r, sum - at);
    *curvature = l.curvature + r.curvature;
    return (s_l - l.slope) - (s_r - r.slope);
  };
  double curvature;
  EdgeConjugate g;
  const auto finish = [&](double at, bool inside) {
    g.alpha_l = at;
    g.alpha_r = sum - at;
    if (inside) {
      excess(at, &curvature);
      g.h_ll = g.h_rr = 1 / curvature;
      g.h_lr = -g.h_ll;
    }
    return g;
  };
  if (excess(low, &curvature) <= 0) return finish(low, false);
  if (excess(high, &curvature) >= 0) return finish(high, false);
  for (int i = 0; i < kMaxNewtonSteps; ++i) {
    const double e = excess(x, &curvature);
    (e > 0 ? low : high) = x;
    double next = x + e / curvature;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (next == x || std::abs(next - x) <= 1e-16 * sum) break;
    x = next;
  }
  return finish(x, true);
}

EdgeConjugate SeparableObjective::InteriorConjugate(double raw_l, double raw_r, double epsilon,
                                                    double s_l, double s_r) const {
  const double ref_l = ClampReference(raw_l, epsilon), ref_r = ClampReference(raw_r, epsilon);
  const double eps = Margin(epsilon);
  const double free_l = WithSlope(ref_l, s_l), free_r = WithSlope(ref_r, s_r);
  EdgeConjugate g;
  if (eps < 0) {
    g.alpha_l = free_l, g.alpha_r = free_r;
  } else {
    g.alpha_l = std::max(free_l, eps), g.alpha_r = std::max(free_r, eps);
  }
  if (eps >= 0 && g.alpha_l + g.alpha_r > kPi - eps) {
    g = MaximiseOnSum(ref_l, ref_r, eps, s_l, s_r);
  } else {
    g.h_ll = g.alpha_l == free_l ? 1 / Distance(ref_l, free_l).curvature : 0;
    g.h_rr = g.alpha_r == free_r ? 1 / Distance(ref_r, free_r).curvature : 0;
  }
  g.value = s_l * g.alpha_l + s_r * g.alpha_r - Distance(ref_l, g.alpha_l).value -
            Distance(ref_r, g.alpha_r).value;
  return g;
}

EdgeConjugate SeparableObjective::BoundaryConjugate(double raw, double epsilon, double s) const {
  const double ref = ClampReference(raw, epsilon), eps = Margin(epsilon);
  const double free = WithSlope(ref, s);
  EdgeConjugate g;
  g.alpha_l = eps < 0 ? free : std::clamp(free, eps, kPi - eps);
  g.h_ll = g.alpha_l == free ? 1 / Distance(ref, free).curvature : 0;
  g.value = s * g.alpha_l - Distance(ref, g.alpha_l).value;
  return g;
}

}  // namespace cirque

#pragma once

#include <algorithm>
#include <cmath>

#include "cirque/core/types.h"
#include "cirque/energy/angle_objective.h"

namespace cirque {

/// An objective of corner angles only. From its scalar distance and where that has a given slope,
/// the conjugates over Q_e follow: clamp each angle to its margin; where the two then exceed pi less
/// theirs, move along that side of Q_e to the maximum (a scalar monotone equation) and clamp to its ends.
///
/// `Derived` is the objective's own class (class NAME final : public SeparableObjective<NAME>), so
/// that its functions are known, and inlined, where the conjugates are compiled: an angle fit calls
/// these for every edge at every step. Beside those of AngleObjective it has
///   double WithSlope(double reference, double slope) const;
/// the x with d delta(x; reference) / dx = slope.
template <class Derived>
class SeparableObjective : public AngleObjective {
 public:
  EdgeConjugate InteriorConjugate(double ref_l, double ref_r, double epsilon, double s_l,
                                  double s_r) const final;
  EdgeConjugate BoundaryConjugate(double ref, double epsilon, double s) const final;

 private:
  const Derived& own() const { return static_cast<const Derived&>(*this); }
  EdgeConjugate MaximiseOnSum(double ref_l, double ref_r, const EdgeMargins& margins, double s_l,
                              double s_r) const;
};

/// Maximises s.a - phi(a) over a_l + a_r = m = pi - theta's margin. With a_l = x: the slope's
/// difference (s_l - delta'(x)) - (s_r - delta'(m - x)) decreases in x.
template <class Derived>
EdgeConjugate SeparableObjective<Derived>::MaximiseOnSum(double ref_l, double ref_r,
                                                         const EdgeMargins& margins, double s_l,
                                                         double s_r) const {
  constexpr int kMaxNewtonSteps = 100;
  const double sum = kPi - margins.theta;
  double low = margins.l, high = sum - margins.r, x = 0.5 * sum;
  const auto excess = [&](double at, double* curvature) {
    const ScalarJet l = own().Distance(ref_l, at), r = own().Distance(ref_r, sum - at);
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

template <class Derived>
EdgeConjugate SeparableObjective<Derived>::InteriorConjugate(double raw_l, double raw_r,
                                                             double epsilon, double s_l,
                                                             double s_r) const {
  const double ref_l = own().ClampReference(raw_l, epsilon),
               ref_r = own().ClampReference(raw_r, epsilon);
  const EdgeMargins margins = own().Margins(raw_l, raw_r, epsilon);
  const bool bounded = margins.theta >= 0;
  const double free_l = own().WithSlope(ref_l, s_l), free_r = own().WithSlope(ref_r, s_r);
  EdgeConjugate g;
  g.alpha_l = bounded ? std::max(free_l, margins.l) : free_l;
  g.alpha_r = bounded ? std::max(free_r, margins.r) : free_r;
  if (bounded && g.alpha_l + g.alpha_r > kPi - margins.theta) {
    g = MaximiseOnSum(ref_l, ref_r, margins, s_l, s_r);
  } else {
    g.h_ll = g.alpha_l == free_l ? 1 / own().Distance(ref_l, free_l).curvature : 0;
    g.h_rr = g.alpha_r == free_r ? 1 / own().Distance(ref_r, free_r).curvature : 0;
  }
  g.value = s_l * g.alpha_l + s_r * g.alpha_r - own().Distance(ref_l, g.alpha_l).value -
            own().Distance(ref_r, g.alpha_r).value;
  return g;
}

template <class Derived>
EdgeConjugate SeparableObjective<Derived>::BoundaryConjugate(double raw, double epsilon,
                                                             double s) const {
  const double ref = own().ClampReference(raw, epsilon);
  const EdgeMargins margins = own().Margins(raw, epsilon);
  const double free = own().WithSlope(ref, s);
  EdgeConjugate g;
  g.alpha_l = margins.theta < 0 ? free : std::clamp(free, margins.l, kPi - margins.theta);
  g.h_ll = g.alpha_l == free ? 1 / own().Distance(ref, free).curvature : 0;
  g.value = s * g.alpha_l - own().Distance(ref, g.alpha_l).value;
  return g;
}

}  // namespace cirque

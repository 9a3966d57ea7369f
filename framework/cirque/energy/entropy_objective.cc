#include "cirque/energy/entropy_objective.h"

#include <algorithm>
#include <cmath>

#include "cirque/core/types.h"
#include "cirque/math/elementary.h"
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

double EntropyObjective::ClampReference(double reference, double epsilon) const {
  return std::max(reference, std::min(epsilon, kLeastCornerMargin));
}

namespace {

/// The maximum over x of s x - delta(x; reference), at a bound.
struct EntropyAngle {
  double x, h, value;
};

EntropyAngle EntropyAt(double x, double reference, double s) {
  return {x, 0, (s - std::log(x / reference)) * x + x - reference};
}

/// That over x >= least.
EntropyAngle EntropyAbove(double least, double reference, double s) {
  const double free = reference * ExponentialOfAny(s);
  return free >= least ? EntropyAngle{free, free, free - reference}
                       : EntropyAt(least, reference, s);
}

/// The maximum over alpha_l + alpha_r = pi - margins.theta.
EdgeConjugate EntropyOnSum(double ref_l, double ref_r, const EdgeMargins& margins, double s_l,
                           double s_r) {
  const double sum = kPi - margins.theta;
  // Exponents relative to the larger slope, which may be beyond doubles.
  const double top = std::max(s_l, s_r);
  const double f_l = ref_l * std::exp(s_l - top), f_r = ref_r * std::exp(s_r - top);
  EdgeConjugate g;
  g.alpha_l = sum * (f_l / (f_l + f_r));
  g.alpha_r = sum * (f_r / (f_l + f_r));
  if (g.alpha_l >= margins.l && g.alpha_r >= margins.r) {
    g.value = sum * (top + std::log((f_l + f_r) / sum)) + sum - ref_l - ref_r;
    g.h_ll = g.h_rr = g.alpha_l * g.alpha_r / sum;
    g.h_lr = -g.h_ll;
    return g;
  }
  g.alpha_l = g.alpha_l < margins.l ? margins.l : sum - margins.r;
  g.alpha_r = sum - g.alpha_l;
  g.value = EntropyAt(g.alpha_l, ref_l, s_l).value + EntropyAt(g.alpha_r, ref_r, s_r).value;
  return g;
}

}  // namespace

EdgeConjugate EntropyObjective::InteriorConjugate(double raw_l, double raw_r, double epsilon,
                                                  double s_l, double s_r) const {
  const double ref_l = ClampReference(raw_l, epsilon), ref_r = ClampReference(raw_r, epsilon);
  const EdgeMargins margins = Margins(raw_l, raw_r, epsilon);
  const EntropyAngle l = EntropyAbove(margins.l, ref_l, s_l);
  const EntropyAngle r = EntropyAbove(margins.r, ref_r, s_r);
  if (l.x + r.x > kPi - margins.theta) return EntropyOnSum(ref_l, ref_r, margins, s_l, s_r);
  return {l.value + r.value, l.x, r.x, l.h, 0, r.h};
}

EdgeConjugate EntropyObjective::BoundaryConjugate(double raw, double epsilon, double s) const {
  const double ref = ClampReference(raw, epsilon);
  const EdgeMargins margins = Margins(raw, epsilon);
  EntropyAngle a = EntropyAbove(margins.l, ref, s);
  if (a.x > kPi - margins.theta) a = EntropyAt(kPi - margins.theta, ref, s);
  return {a.value, a.x, 0, a.h, 0, 0};
}

}  // namespace cirque

#include "cirque/energy/entropy_objective.h"

#include <algorithm>
#include <cmath>

#include <glog/logging.h>

#include "cirque/core/types.h"
#include "cirque/math/elementary.h"
#include "cirque/math/elementary_arrays.h"
#include "cirque/math/itakura_saito.h"
#include "cirque/math/parallel_chunks.h"

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

/// That over x >= least, given e^s.
EntropyAngle EntropyAbove(double least, double reference, double s, double exponential) {
  const double free = reference * exponential;
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

EdgeConjugate EntropyObjective::ConjugateOf(const EdgeSlopes& edge, double epsilon, double exp_l,
                                            double exp_r) const {
  const double ref_l = ClampReference(edge.ref_l, epsilon);
  if (edge.is_boundary) {
    const EdgeMargins margins = Margins(edge.ref_l, epsilon);
    EntropyAngle a = EntropyAbove(margins.l, ref_l, edge.s_l, exp_l);
    if (a.x > kPi - margins.theta) a = EntropyAt(kPi - margins.theta, ref_l, edge.s_l);
    return {a.value, a.x, 0, a.h, 0, 0};
  }
  const double ref_r = ClampReference(edge.ref_r, epsilon);
  const EdgeMargins margins = Margins(edge.ref_l, edge.ref_r, epsilon);
  const EntropyAngle l = EntropyAbove(margins.l, ref_l, edge.s_l, exp_l);
  const EntropyAngle r = EntropyAbove(margins.r, ref_r, edge.s_r, exp_r);
  if (l.x + r.x > kPi - margins.theta) {
    return EntropyOnSum(ref_l, ref_r, margins, edge.s_l, edge.s_r);
  }
  return {l.value + r.value, l.x, r.x, l.h, 0, r.h};
}

EdgeConjugate EntropyObjective::InteriorConjugate(double raw_l, double raw_r, double epsilon,
                                                  double s_l, double s_r) const {
  return ConjugateOf({raw_l, raw_r, s_l, s_r, false}, epsilon, ExponentialOfAny(s_l),
                     ExponentialOfAny(s_r));
}

EdgeConjugate EntropyObjective::BoundaryConjugate(double raw, double epsilon, double s) const {
  return ConjugateOf({raw, 0, s, 0, true}, epsilon, ExponentialOfAny(s), 1);
}

void EntropyObjective::Conjugates(std::span<const EdgeSlopes> edges, double epsilon,
                                  std::span<EdgeConjugate> conjugates) const {
  CHECK_EQ(edges.size(), conjugates.size());
  ParallelChunks(static_cast<int>(edges.size()), [&](int first, int end) {
    ChunkOf<double, 2> slope(end - first), exponential(end - first);
    for (int e = first; e < end; ++e) {
      slope[2 * (e - first)] = edges[e].s_l;
      slope[2 * (e - first) + 1] = edges[e].s_r;
    }
    Exponentials(slope, exponential);
    for (int e = first; e < end; ++e) {
      const double* of_edge = &exponential[2 * (e - first)];
      conjugates[e] = ConjugateOf(edges[e], epsilon, of_edge[0], of_edge[1]);
    }
  });
}

}  // namespace cirque

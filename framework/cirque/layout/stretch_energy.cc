#include "cirque/layout/stretch_energy.h"

#include <cmath>

namespace cirque {
namespace {

/// (p + r) (1 + 1/d^2) - 2 with d = p - r.
StretchTerms SymmetricDirichlet(double p, double r, double /*weight*/) {
  const double d = p - r, sum = p + r;
  const double square = 1 / (d * d), cube = square / d, fourth = square * square;
  // Without the cancellation of 2 near an isometry.
  const double value = 2 * r + (d - 1) * (d - 1) / d + 2 * r * square;
  const double twice = 6 * sum * fourth;
  return {value,
          1 + square - 2 * sum * cube,
          1 + square + 2 * sum * cube,
          twice - 4 * cube,
          -twice,
          twice + 4 * cube};
}

constexpr double kBarrier = 0.01;  ///< of symmetric Dirichlet in `arap`

/// 2 (sqrt(p) - 1)^2 + 2 r and the barrier.
StretchTerms Arap(double p, double r, double weight) {
  const double root = std::sqrt(p);
  const StretchTerms barrier = SymmetricDirichlet(p, r, weight);
  return {2 * (root - 1) * (root - 1) + 2 * r + kBarrier * barrier.value,
          2 - 2 / root + kBarrier * barrier.p,
          2 + kBarrier * barrier.r,
          1 / (p * root) + kBarrier * barrier.pp,
          kBarrier * barrier.pr,
          kBarrier * barrier.rr};
}

/// 4 r / d.
StretchTerms Mips(double p, double r) {
  const double inverse = 1 / (p - r), square = inverse * inverse, cube = square * inverse;
  return {4 * r * inverse, -4 * r * square,     4 * p * square,
          8 * r * cube,    -4 * (p + r) * cube, 8 * p * cube};
}

/// d + 1/d - 2.
StretchTerms Determinant(double p, double r) {
  const double d = p - r, slope = 1 - 1 / (d * d), curvature = 2 / (d * d * d);
  return {(d - 1) * (d - 1) / d, slope, -slope, curvature, -curvature, curvature};
}

StretchTerms Blend(double p, double r, double weight) {
  const StretchTerms x = Mips(p, r), y = Determinant(p, r);
  const auto mix = [weight](double of_x, double of_y) { return of_x + weight * (of_y - of_x); };
  return {mix(x.value, y.value), mix(x.p, y.p),   mix(x.r, y.r),
          mix(x.pp, y.pp),       mix(x.pr, y.pr), mix(x.rr, y.rr)};
}

}  // namespace

const Registry<StretchEnergy>& StretchEnergies() {
  static const Registry<StretchEnergy> kTable(
      "stretch energy",
      {{"symmetric_dirichlet", {SymmetricDirichlet}}, {"arap", {Arap}}, {"area", {Blend, true}}});
  return kTable;
}

}  // namespace cirque

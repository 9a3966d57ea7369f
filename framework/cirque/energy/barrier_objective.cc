#include "cirque/energy/barrier_objective.h"

#include <algorithm>
#include <cmath>

#include "cirque/core/types.h"
#include "cirque/math/itakura_saito.h"

namespace cirque {
namespace {

constexpr int kMaxNewtonSteps = 200;

/// The u > max(0, -p, -q) with 1/u + 1/(u + p) + 1/(u + q) = pi. The left side is convex and
/// decreasing and at least pi at the start, so Newton's iterates increase towards the root; they
/// stop when rounding ends that.
struct InverseAngles {
  double u, up, uq;  ///< u, u + p, u + q, each without cancellation
};

InverseAngles SolveInverse(double p, double q) {
  // Measured from the largest pole, whose term 1/w rules: w = u - pole.
  const double pole = std::max({0.0, -p, -q});
  const double a = pole, b = pole + p, c = pole + q;
  double w = 1 / kPi;
  for (int i = 0; i < kMaxNewtonSteps; ++i) {
    const double x = 1 / (w + a), y = 1 / (w + b), z = 1 / (w + c);
    const double step = (x + y + z - kPi) / (x * x + y * y + z * z);
    const double next = w + step;
    if (!(step > 1e-16 * w)) break;
    w = next;
  }
  return {w + a, w + b, w + c};
}

}  // namespace

ScalarJet BarrierObjective::Distance(double reference, double x) const {
  const ScalarJet is = ItakuraSaito(x / reference);
  return {is.value, is.slope / reference, is.curvature / (reference * reference)};
}

ResidualJet BarrierObjective::Residual(double reference, double x) const {
  const ResidualJet r = ItakuraSaitoResidual(x / reference);
  return {r.value, r.slope / reference};
}

double BarrierObjective::ClampReference(double reference, double epsilon) const {
  return std::max(reference, epsilon);
}

EdgeConjugate BarrierObjective::InteriorConjugate(double raw_l, double raw_r, double epsilon,
                                                  double s_l, double s_r) const {
  const double ref_l = ClampReference(raw_l, epsilon), ref_r = ClampReference(raw_r, epsilon);
  const double ref_theta = ClampReference(kPi - raw_l - raw_r, epsilon);
  const InverseAngles inverse =
      SolveInverse(1 / ref_l - 1 / ref_theta - s_l, 1 / ref_r - 1 / ref_theta - s_r);
  EdgeConjugate g;
  g.alpha_l = 1 / inverse.up;
  g.alpha_r = 1 / inverse.uq;
  const double theta = 1 / inverse.u;
  // The inverse of diag(1/a^2, 1/b^2) + 11'/t^2.
  const double a2 = g.alpha_l * g.alpha_l, b2 = g.alpha_r * g.alpha_r, t2 = theta * theta;
  g.h_ll = a2 * (t2 + b2) / (t2 + a2 + b2);
  g.h_rr = b2 * (t2 + a2) / (t2 + a2 + b2);
  g.h_lr = -a2 * b2 / (t2 + a2 + b2);
  g.value = s_l * g.alpha_l + s_r * g.alpha_r - Distance(ref_l, g.alpha_l).value -
            Distance(ref_r, g.alpha_r).value - Distance(ref_theta, theta).value;
  return g;
}

EdgeConjugate BarrierObjective::BoundaryConjugate(double raw, double epsilon, double s) const {
  const double ref = ClampReference(raw, epsilon), ref_theta = ClampReference(kPi - raw, epsilon);
  const double p = 1 / ref - 1 / ref_theta - s;
  // 1/u + 1/(u + p) = pi: the two inverses are the roots (2 -+ pi p + sqrt(pi^2 p^2 + 4)) / (2 pi).
  const double root = std::sqrt(kPi * kPi * p * p + 4);
  const double larger = (2 + kPi * std::abs(p) + root) / (2 * kPi);
  const double smaller = larger / (kPi * larger - 1);
  EdgeConjugate g;
  g.alpha_l = 1 / (p > 0 ? larger : smaller);
  const double theta = 1 / (p > 0 ? smaller : larger);
  const double a2 = g.alpha_l * g.alpha_l, t2 = theta * theta;
  g.h_ll = a2 * t2 / (a2 + t2);
  g.value = s * g.alpha_l - Distance(ref, g.alpha_l).value - Distance(ref_theta, theta).value;
  return g;
}

}  // namespace cirque

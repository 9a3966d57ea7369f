#include "cirque/math/circle_angle.h"

#include <algorithm>
#include <cmath>

#include "cirque/core/types.h"
#include "cirque/math/arctangent.h"
#include "cirque/math/clausen.h"
#include "cirque/math/gauss_legendre.h"
#include "cirque/math/half_angle_formulas.h"
#include "cirque/math/pi.h"

namespace cirque {

namespace {

double Square(double x) { return x * x; }

}  // namespace

// By half angles: one sine and cosine of the same number, which are one call.

CircleAngle CircleAngle::FromExterior(double theta) {
  const double sine = std::sin(0.5 * theta), cosine = std::cos(0.5 * theta);
  return {theta, 2.0 * sine * cosine, 2.0 * Square(sine)};
}

double CircleAngle::Theta(double alpha_i, double alpha_j) {
  const double sum = alpha_i + alpha_j;
  const double rounded_j = sum - alpha_i;
  const double error = (alpha_i - (sum - rounded_j)) + (alpha_j - rounded_j);
  return (kPi - sum) + (kPiLow - error);
}

CircleAngle CircleAngle::FromCorners(double alpha_i, double alpha_j) {
  const double theta = Theta(alpha_i, alpha_j), sum = alpha_i + alpha_j;
  if (theta < 0.5 * kPi) return FromExterior(theta);
  const double sine = std::sin(0.5 * sum), cosine = std::cos(0.5 * sum);
  return {theta, 2.0 * sine * cosine, 2.0 * Square(cosine)};
}

double HalfAngle(double d, double theta) { return HalfAngle(d, CircleAngle::FromExterior(theta)); }

double HalfAngle(double d, const CircleAngle& angle) {
  const auto sides =
      SidesOfHalfAngle(d, angle.sine, angle.one_minus_cosine, DecayByAny(std::abs(d)));
  return Arctangent(sides.sine, sides.cosine);
}

double HalfAngleWeight(double d, double theta) {
  return HalfAngleWeight(d, CircleAngle::FromExterior(theta));
}

double HalfAngleByThetaStar(double d, double theta_star) {
  if (d < 0) return 1 - HalfAngleByThetaStar(-d, theta_star);
  const double decay = std::exp(-d), cosine = std::cos(theta_star);
  return decay * (decay + cosine) / (1 + 2 * decay * cosine + decay * decay);
}

double HalfAngleWeight(double d, const CircleAngle& angle) {
  return WeightOfHalfAngle(angle.sine, angle.one_minus_cosine, DecayByAny(std::abs(d)));
}

namespace {

/// Steps shorter than this times the distance to a singularity are integrated, not subtracted.
constexpr double kNear = 0.5;
/// A difference of Clausen values loses no more than the inverse of this.
constexpr double kShortStep = 0.0625;

/// Cl2(2 (a + h)) - Cl2(2 a), relatively accurate as far as h log h, given a + h + b = pi, where
/// each of a, h, b >= 0 is known to its own accuracy. Symmetric in a and b.
double ClausenStep(double a, double h, double b) {
  if (a > b) std::swap(a, b);
  if (h < kShortStep && h < kNear * a) {
    // From 0 to h, not from a to a + h, which would round a short step away.
    return -2.0 * Integrate([a](double t) { return std::log(2.0 * std::sin(a + t)); }, 0.0, h);
  }
  const double end = a + h < 0.5 * kPi ? Clausen(2.0 * (a + h)) : -Clausen(2.0 * b);
  return end - Clausen(2.0 * a);
}

/// An edge with d and its angles; alpha_i <= alpha_j by exchange of the two faces if need be.
struct Edge {
  Edge(double log_ratio, double angle_i, double angle_j)
      : exchanged(angle_i > angle_j),
        alpha_i(std::min(angle_i, angle_j)),
        alpha_j(std::max(angle_i, angle_j)),
        angle(CircleAngle::FromCorners(angle_i, angle_j)),
        d(exchanged ? -log_ratio : log_ratio) {}

  bool exchanged;
  double alpha_i, alpha_j;
  CircleAngle angle;
  double d;
};

/// delta = alpha_i - phi_i and E / delta^2, which is smooth and positive also at delta = 0.
struct Excess {
  double delta;
  double ratio;
};

/// delta from d - d_e without cancellation, by turning the vector of which HalfAngle is the
/// direction; valid for |delta| < pi/4.
double SmallDelta(const Edge& e, double offset) {
  const double shift = std::sin(e.alpha_j) * std::expm1(offset);
  return Arctangent(shift * std::sin(e.alpha_i), e.angle.sine + shift * std::cos(e.alpha_i));
}

/// E / delta^2 = 2 sin theta int_0^1 s ds / (sin(alpha_i - delta s) sin(alpha_j + delta s)): the
/// integral of psi_e' with phi_i as variable, whose integrand has one sign and no sharp peak.
double NearRatio(const Edge& e, double delta) {
  const double sin_i = std::sin(e.alpha_i), cos_i = std::cos(e.alpha_i);
  const double sin_j = std::sin(e.alpha_j), cos_j = std::cos(e.alpha_j);
  const auto integrand = [&](double s) {
    const double sin_t = std::sin(delta * s), cos_t = std::cos(delta * s);
    return s / ((sin_i * cos_t - cos_i * sin_t) * (sin_j * cos_t + cos_j * sin_t));
  };
  return 2.0 * e.angle.sine * Integrate(integrand, 0.0, 1.0);
}

/// E in closed form, 2 delta d + sum over both faces of Cl2(2 phi) - Cl2(2 alpha). Of the two ways
/// to pair the four values the one with the shorter steps keeps every term as small as E.
Excess FarExcess(const Edge& e) {
  const double phi_i = HalfAngle(e.d, e.angle), phi_j = HalfAngle(-e.d, e.angle);
  const double delta = e.alpha_i - phi_i, step = std::abs(delta), theta = e.angle.theta;
  double clausens = 0.0;
  if (theta < step) {
    clausens = ClausenStep(e.alpha_i, theta, e.alpha_j) - ClausenStep(phi_i, theta, phi_j);
  } else if (delta > 0.0) {
    clausens =
        ClausenStep(e.alpha_j, step, phi_i + theta) - ClausenStep(phi_i, step, e.alpha_j + theta);
  } else {
    clausens =
        ClausenStep(e.alpha_i, step, phi_j + theta) - ClausenStep(phi_j, step, e.alpha_i + theta);
  }
  return {delta, (2.0 * delta * e.d + clausens) / (delta * delta)};
}

Excess ComputeExcess(const Edge& e) {
  const double offset = e.d - MinimalLogRatio(e.alpha_i, e.alpha_j);
  // |delta| < alpha_i / 2 implies |d - d_e| < log 3.
  if (std::abs(offset) < 1.2) {
    const double delta = SmallDelta(e, offset);
    if (std::abs(delta) < kNear * e.alpha_i) return {delta, NearRatio(e, delta)};
  }
  return FarExcess(e);
}

}  // namespace

double EdgePotentialValue(double d, double theta, double phi_i, double phi_j) {
  return (phi_j - phi_i) * d + Clausen(2.0 * theta) - ClausenStep(phi_i, theta, phi_j);
}

ScalarJet EdgePotential(double d, double theta) {
  const CircleAngle angle = CircleAngle::FromExterior(theta);
  const double slope =
      2.0 * Arctangent(std::tanh(0.5 * d) * std::cos(0.5 * theta), std::sin(0.5 * theta));
  return {EdgePotentialValue(d, theta, HalfAngle(d, angle), HalfAngle(-d, angle)), slope,
          HalfAngleWeight(d, angle)};
}

double MinimalLogRatio(double alpha_i, double alpha_j) {
  // sin alpha_j - sin alpha_i as a product, then log1p of it over the smaller sine.
  const double difference = 2.0 * std::sin(0.5 * CircleAngle::FromCorners(alpha_i, alpha_j).theta) *
                            std::sin(0.5 * (alpha_j - alpha_i));
  return difference >= 0.0 ? std::log1p(difference / std::sin(alpha_i))
                           : -std::log1p(-difference / std::sin(alpha_j));
}

ScalarJet EdgeExcess(double d, double alpha_i, double alpha_j) {
  const Edge edge(d, alpha_i, alpha_j);
  const Excess excess = ComputeExcess(edge);
  const double slope = 2.0 * excess.delta;
  return {excess.ratio * excess.delta * excess.delta, edge.exchanged ? -slope : slope,
          HalfAngleWeight(d, edge.angle)};
}

ResidualJet EdgeResidual(double d, double alpha_i, double alpha_j) {
  const Edge edge(d, alpha_i, alpha_j);
  const Excess excess = ComputeExcess(edge);
  const double r = excess.delta * std::sqrt(2.0 * excess.ratio);
  return {edge.exchanged ? -r : r, std::sqrt(2.0 / excess.ratio)};
}

}  // namespace cirque

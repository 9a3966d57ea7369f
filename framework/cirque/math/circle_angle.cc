#include "cirque/math/circle_angle.h"

#include <cmath>

#include "cirque/core/types.h"

namespace cirque {
namespace {

constexpr double kPiLow = 0x1.1a62633145c07p-53;  // pi - kPi

double Square(double x) { return x * x; }

}  // namespace

CircleAngle CircleAngle::FromExterior(double theta) {
  return {theta, std::sin(theta), 2.0 * Square(std::sin(0.5 * theta))};
}

CircleAngle CircleAngle::FromCorners(double alpha_i, double alpha_j) {
  const double sum = alpha_i + alpha_j;
  const double rounded_j = sum - alpha_i;
  const double error = (alpha_i - (sum - rounded_j)) + (alpha_j - rounded_j);
  const double theta = (kPi - sum) + (kPiLow - error);
  if (theta < 0.5 * kPi) return FromExterior(theta);
  return {theta, std::sin(sum), 2.0 * Square(std::cos(0.5 * sum))};
}

double HalfAngle(double d, double theta) { return HalfAngle(d, CircleAngle::FromExterior(theta)); }

double HalfAngle(double d, const CircleAngle& angle) {
  // e^d - cos theta = expm1(d) + (1 - cos theta), both scaled by e^{-d} where d > 0. A cancellation
  // of the two terms happens only near phi = pi/2, where it is harmless.
  const double scale = d > 0.0 ? std::exp(-d) : 1.0;
  const double growth = d > 0.0 ? -std::expm1(-d) : std::expm1(d);
  return std::atan2(scale * angle.sine, growth + scale * angle.one_minus_cosine);
}

double HalfAngleWeight(double d, double theta) {
  return HalfAngleWeight(d, CircleAngle::FromExterior(theta));
}

double HalfAngleWeight(double d, const CircleAngle& angle) {
  // sin theta / (cosh d - cos theta), both scaled by 2 q with q = e^{-|d|}.
  const double q = std::exp(-std::abs(d));
  const double one_minus_q = -std::expm1(-std::abs(d));
  return 2.0 * q * angle.sine / (Square(one_minus_q) + 2.0 * q * angle.one_minus_cosine);
}

}  // namespace cirque

#include "cirque/math/circle_angle.h"

#include <cmath>

namespace cirque {
namespace {

/// 1 - cos theta without cancellation.
double OneMinusCos(double theta) {
  const double s = std::sin(0.5 * theta);
  return 2.0 * s * s;
}

}  // namespace

double HalfAngle(double d, double theta) {
  // e^d - cos theta = expm1(d) + (1 - cos theta), both scaled by e^{-d} where d > 0. A cancellation
  // of the two terms happens only near phi = pi/2, where it is harmless.
  const double scale = d > 0.0 ? std::exp(-d) : 1.0;
  const double growth = d > 0.0 ? -std::expm1(-d) : std::expm1(d);
  return std::atan2(scale * std::sin(theta), growth + scale * OneMinusCos(theta));
}

double HalfAngleWeight(double d, double theta) {
  // cosh d - cos theta, scaled by 2 q with q = e^{-|d|}.
  const double q = std::exp(-std::abs(d));
  const double one_minus_q = -std::expm1(-std::abs(d));
  return 2.0 * q * std::sin(theta) / (one_minus_q * one_minus_q + 2.0 * q * OneMinusCos(theta));
}

}  // namespace cirque

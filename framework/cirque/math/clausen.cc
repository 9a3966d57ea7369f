#include "cirque/math/clausen.h"

#include <array>
#include <cmath>
#include <numbers>

#include "cirque/core/types.h"
#include "cirque/math/clausen_coefficients.h"
#include "cirque/math/pi.h"

namespace cirque {
namespace {

constexpr double kTwoPi = 2.0 * kPi;
constexpr double kLog2Low = 0x1.abc9e3b39803fp-56;  // log 2 - ln2
/// 2 pi in three parts, the first two of 33 bits: their multiples by k < 2^20 are exact.
constexpr std::array<double, 3> kTwoPiParts = {0x1.921fb544p+2, 0x1.0b4611a6p-32,
                                               0x1.3198a2e037073p-67};
constexpr double kLargestReduced = 1e6;

/// Polynomial in t as two interleaved Horner chains in t^2: half the latency of one.
template <std::size_t N>
double Polynomial(const std::array<double, N>& c, double t) {
  static_assert(N % 2 == 0);
  const double t2 = t * t;
  double even = c[N - 2], odd = c[N - 1];
  for (std::size_t k = N - 2; k >= 2; k -= 2) {
    even = even * t2 + c[k - 2];
    odd = odd * t2 + c[k - 1];
  }
  return even + t * odd;
}

/// 0 <= x <= pi / 2.
double NearZero(double x) {
  if (x == 0.0) return 0.0;
  const double t = x * x;
  // The large term x stands alone: what is added to it is small where Cl2 is near 1.
  return x + x * (t * Polynomial(kClausenNearZero, t) - std::log(x));
}

/// Cl2(pi - y), |y| <= pi / 2.
double NearPi(double y) {
  const double t = y * y;
  return y * (std::numbers::ln2 + (kLog2Low + t * Polynomial(kClausenNearPi, t)));
}

/// x in [0, 2 pi].
double OnePeriod(double x) {
  if (x <= 0.5 * kPi) return NearZero(x);
  if (x <= 1.5 * kPi) return NearPi((kPi - x) + kPiLow);
  return -NearZero((kTwoPi - x) + 2.0 * kPiLow);
}

/// x minus the nearest multiple of 2 pi.
double Reduce(double x) {
  if (!(std::abs(x) <= kLargestReduced)) return std::atan2(std::sin(x), std::cos(x));
  const double k = std::nearbyint(x / kTwoPi);
  return ((x - k * kTwoPiParts[0]) - k * kTwoPiParts[1]) - k * kTwoPiParts[2];
}

}  // namespace

double Clausen(double x) {
  if (!(std::abs(x) <= kTwoPi)) x = Reduce(x);
  return std::copysign(1.0, x) * OnePeriod(std::abs(x));
}

double Lobachevsky(double x) { return 0.5 * Clausen(2.0 * x); }

}  // namespace cirque

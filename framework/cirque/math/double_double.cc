#include "cirque/math/double_double.h"

#include <algorithm>

namespace cirque {
namespace {

constexpr double kLn2High = 0x1.62e42fefa39efp-1, kLn2Low = 0x1.abc9e3b39803fp-56;
constexpr int kHalvings = 9, kTerms = 8;
constexpr double kNegligible = 40;  ///< e^-40 in a double is right to 1e-33

/// e^x - 1 for |x| <= ln(2) / 2: by Taylor's series at x / 512 and (1 + s)^2 - 1 = s (2 + s).
DoubleDouble Expm1Reduced(DoubleDouble x) {
  for (int i = 0; i < kHalvings; ++i) x = Half(x);
  DoubleDouble sum = x, term = x;
  for (int k = 2; k <= kTerms; ++k) {
    const double inverse = 1.0 / k;
    const DoubleDouble exact_inverse(inverse, std::fma(-inverse, k, 1.0) / k);
    term = term * x * exact_inverse;
    sum = sum + term;
  }
  for (int i = 0; i < kHalvings; ++i) sum = sum * (DoubleDouble(2) + sum);
  return sum;
}

/// log(1 + z) for 0 < z <= 1, by one step of Newton's method.
DoubleDouble Log1p(const DoubleDouble& z) {
  const double first = std::log1p(z.high);
  return DoubleDouble(first) + ((DoubleDouble(1) + z) * Exp(DoubleDouble(-first)) - 1.0);
}

}  // namespace

DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const double product = a.high * b.high, lost = std::fma(a.high, b.high, -product);
  return {product, lost + (a.high * b.low + a.low * b.high)};
}

DoubleDouble Exp(const DoubleDouble& x) {
  const double powers = std::round(x.high / kLn2High);
  const DoubleDouble ln2(kLn2High, kLn2Low);
  const DoubleDouble grown = DoubleDouble(1) + Expm1Reduced(x - DoubleDouble(powers) * ln2);
  const int exponent = static_cast<int>(powers);
  return {std::ldexp(grown.high, exponent), std::ldexp(grown.low, exponent)};
}

DoubleDouble Expm1(const DoubleDouble& x) {
  return std::abs(x.high) < 0.5 * kLn2High ? Expm1Reduced(x) : Exp(x) - 1.0;
}

DoubleDouble Sqrt(const DoubleDouble& a) {
  if (!(a.high > 0)) return 0;
  const double root = std::sqrt(a.high);
  return {root, (a - DoubleDouble(root) * root).Value() / (2 * root)};
}

DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const double first = a.high / b.high;
  const DoubleDouble left = a - b * first;
  const double second = left.high / b.high;
  return DoubleDouble(first, second) + (left - b * second).Value() / b.high;
}

DoubleDouble LogAddExp(const DoubleDouble& x, const DoubleDouble& y) {
  const bool swapped = x < y;
  const DoubleDouble &larger = swapped ? y : x, &smaller = swapped ? x : y;
  const DoubleDouble apart = smaller - larger;
  if (apart.high < -kNegligible) return larger + std::exp(apart.high);
  return larger + Log1p(Exp(apart));
}

}  // namespace cirque

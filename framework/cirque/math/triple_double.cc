#include "cirque/math/triple_double.h"

#include <algorithm>

namespace cirque {
namespace {

constexpr double kLn2High = 0x1.62e42fefa39efp-1, kLn2Middle = 0x1.abc9e3b39803fp-56,
                 kLn2Low = 0x1.7b57a079a1934p-111;
constexpr int kHalvings = 9, kTerms = 14;
constexpr double kNegligible = 75;  ///< e^-75 in a double is right to 1e-48

/// e^x - 1 for |x| <= ln(2) / 2: by Taylor's series at x / 512 and (1 + s)^2 - 1 = s (2 + s).
TripleDouble Expm1Reduced(TripleDouble x) {
  for (int i = 0; i < kHalvings; ++i) x = Half(x);
  TripleDouble sum = x, term = x;
  for (int k = 2; k <= kTerms; ++k) {
    term = term * x / TripleDouble(k);
    sum = sum + term;
  }
  for (int i = 0; i < kHalvings; ++i) sum = sum * (TripleDouble(2) + sum);
  return sum;
}

/// log(1 + z) for 0 < z <= 1: in a double, and the rest by its series, of which the fourth term is below
/// 1e-62.
TripleDouble Log1p(const TripleDouble& z) {
  const double first = std::log1p(z.high);
  const TripleDouble rest = (TripleDouble(1) + z) * Exp(-first) - 1.0;
  const TripleDouble square = rest * rest;
  return TripleDouble(first) + (rest - Half(square) + square * rest / TripleDouble(3));
}

/// a b as a double and what that is off by, exactly.
struct TwoProduct {
  double product, rest;

  TwoProduct(double a, double b) : product(a * b), rest(std::fma(a, b, -product)) {}
};

}  // namespace

TripleDouble operator*(const TripleDouble& a, const TripleDouble& b) {
  const TwoProduct first(a.high, b.high), one(a.high, b.middle), other(a.middle, b.high);
  const TwoSum second(one.product, other.product), with_rest(second.sum, first.rest);
  const double third =
      a.high * b.low + a.middle * b.middle + a.low * b.high + one.rest + other.rest;
  return SumOf(first.product, with_rest.sum, third + second.rest + with_rest.rest);
}

TripleDouble Exp(const TripleDouble& x) {
  const double powers = std::round(x.high / kLn2High);
  const TripleDouble ln2(kLn2High, kLn2Middle, kLn2Low);
  const TripleDouble grown = TripleDouble(1) + Expm1Reduced(x - TripleDouble(powers) * ln2);
  const int exponent = static_cast<int>(powers);
  return {std::ldexp(grown.high, exponent), std::ldexp(grown.middle, exponent),
          std::ldexp(grown.low, exponent)};
}

TripleDouble Expm1(const TripleDouble& x) {
  return std::abs(x.high) < 0.5 * kLn2High ? Expm1Reduced(x) : Exp(x) - 1.0;
}

TripleDouble Sqrt(const TripleDouble& a) {
  if (!(a.high > 0)) return 0;
  const double first = std::sqrt(a.high);
  TripleDouble root = first;
  for (int i = 0; i < 2; ++i) root = root + (a - root * root).high / (2 * first);
  return root;
}

TripleDouble operator/(const TripleDouble& a, const TripleDouble& b) {
  const double first = a.high / b.high;
  TripleDouble left = a - b * first;
  const double second = left.high / b.high;
  left = left - b * second;
  return SumOf(first, second, left.high / b.high);
}

TripleDouble LogAddExp(const TripleDouble& x, const TripleDouble& y) {
  const bool swapped = x < y;
  const TripleDouble &larger = swapped ? y : x, &smaller = swapped ? x : y;
  const TripleDouble apart = smaller - larger;
  if (apart.high < -kNegligible) return larger + std::exp(apart.high);
  return larger + Log1p(Exp(apart));
}

}  // namespace cirque

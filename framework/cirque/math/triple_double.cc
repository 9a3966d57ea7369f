#include "cirque/math/triple_double.h"

#include <algorithm>

namespace cirque {
namespace {

constexpr double kLn2High = 0x1.62e42fefa39efp-1, kLn2Middle = 0x1.abc9e3b39803fp-56,
                 kLn2Low = 0x1.7b57a079a1934p-111;
constexpr int kHalvings = 9;
constexpr double kNegligible = 75;  ///< e^-75 in a double is right to 1e-48

/// Taylor's coefficients, of which the further ones need one double's digits at |x| < 7e-4.
constexpr TripleDouble kCoefficients[] = {
    {0x1.71de3a556c734p-19, -0x1.c154f8ddc6c00p-73, 0x1.71de3a556c734p-127},   // 1 / 9!
    {0x1.a01a01a01a01ap-16, 0x1.a01a01a01a01ap-76, 0x1.a01a01a01a01ap-136},    // 1 / 8!
    {0x1.a01a01a01a01ap-13, 0x1.a01a01a01a01ap-73, 0x1.a01a01a01a01ap-133},    // 1 / 7!
    {0x1.6c16c16c16c17p-10, -0x1.f49f49f49f49fp-65, -0x1.27d27d27d27d2p-119},  // 1 / 6!
    {0x1.1111111111111p-7, 0x1.1111111111111p-63, 0x1.1111111111111p-119},     // 1 / 5!
    {0x1.5555555555555p-5, 0x1.5555555555555p-59, 0x1.5555555555555p-113},     // 1 / 4!
    {0x1.5555555555555p-3, 0x1.5555555555555p-57, 0x1.5555555555555p-111},     // 1 / 3!
    {0x1.0000000000000p-1, 0, 0},                                              // 1 / 2!
};
constexpr double kFurther[] = {1.0 / 87178291200, 1.0 / 6227020800, 1.0 / 479001600, 1.0 / 39916800,
                               1.0 / 3628800};  ///< 1 / 14!, ..., 1 / 10!

/// e^x - 1 for |x| <= ln(2) / 2: by Taylor's series at x / 512 and (1 + s)^2 - 1 = s (2 + s).
TripleDouble Expm1Reduced(TripleDouble x) {
  for (int i = 0; i < kHalvings; ++i) x = Half(x);
  double further = 0;
  for (const double coefficient : kFurther) further = further * x.high + coefficient;
  TripleDouble sum = further;
  for (const TripleDouble& coefficient : kCoefficients) sum = sum * x + coefficient;
  sum = sum * x * x + x;
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

#include "cirque/math/elementary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

#include "cirque/core/types.h"
#include "cirque/math/arctangent.h"
#include "cirque/math/elementary_arrays.h"
#include "cirque/math/pi.h"

namespace cirque {
namespace {

using Exact = boost::multiprecision::cpp_bin_float_50;

/// By how many of its last places a number is off.
double Ulps(double found, const Exact& exact) {
  const double rounded = std::abs(static_cast<double>(exact));
  const double ulp = std::nextafter(rounded, std::numeric_limits<double>::infinity()) - rounded;
  return std::abs(static_cast<double>((Exact(found) - exact) / Exact(ulp)));
}

/// Numbers between two, half of them with any exponent.
std::vector<double> Numbers(double least, double most, int count) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> even(least, most), exponent(-60, 0);
  std::vector<double> x = {least, most};
  while (static_cast<int>(x.size()) < count) {
    x.push_back(even(random));
    x.push_back(even(random) * std::exp2(exponent(random)));
  }
  return x;
}

TEST(Elementary, ExponentialsAgreeWithFiftyDigits) {
  double most = 0, of_left = 0, of_gone = 0;
  for (const double x : Numbers(-kLargestExponent, kLargestExponent, 20000)) {
    most = std::max(most, Ulps(Exponential(x), exp(Exact(x))));
  }
  for (const double x : Numbers(0, kLargestExponent, 20000)) {
    if (x == 0) continue;
    const Decay<double> decay = DecayBy(x);
    of_left = std::max(of_left, Ulps(decay.left, exp(-Exact(x))));
    of_gone = std::max(of_gone, Ulps(decay.gone, -expm1(-Exact(x))));
  }
  EXPECT_LT(most, 1);
  EXPECT_LT(of_left, 1);
  EXPECT_LT(of_gone, 2);
  EXPECT_GT(of_gone, 0);
  EXPECT_EQ(Exponential(0.0), 1);
  EXPECT_EQ(DecayBy(0.0).gone, 0);
}

TEST(Elementary, LogarithmsAgreeWithFiftyDigits) {
  double most = 0;
  std::vector<double> numbers = Numbers(0.5, 2, 20000);
  for (const double x : Numbers(0, 1e-3, 5000)) numbers.push_back(1 + x), numbers.push_back(1 - x);
  for (const double x : Numbers(-700, 700, 5000)) numbers.push_back(std::exp(x));
  for (const double x : numbers) {
    if (x != 1) most = std::max(most, Ulps(Logarithm(x), log(Exact(x))));
  }
  EXPECT_LT(most, 1);
  EXPECT_GT(most, 0);
  EXPECT_EQ(Logarithm(1.0), 0);
  EXPECT_EQ(Logarithm(std::numeric_limits<double>::min()),
            std::log(std::numeric_limits<double>::min()));
}

TEST(Elementary, SinesAgreeWithFiftyDigitsAtBothEndsToo) {
  double most = 0;
  std::vector<double> angles = Numbers(0, kPi, 20000);
  for (const double x : Numbers(0, 1e-3, 5000)) {
    angles.push_back(kPi - x);
    angles.push_back(kPi / 2 + x);
    angles.push_back(kPi / 4 - x);
  }
  for (const double x : angles) most = std::max(most, Ulps(SineToPi(x), sin(Exact(x))));
  EXPECT_LT(most, 1.1);
  EXPECT_GT(most, 0);
}

// Four at a time and one after another, whatever stands beside a number, to the last bit; out of range
// the library's.
TEST(ElementaryArrays, AreTheSingleFunctions) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<double> x = Numbers(0, kPi, 301), y = x;
  std::rotate(y.begin(), y.begin() + 17, y.end());
  std::vector<double> e(x.size()), l(x.size()), s(x.size()), a(x.size());
  for (const double strange : {1.5, -3.0, 800.0, -900.0, 5e-324, kInfinity}) {
    x[100] = strange;
    Exponentials(x, e);
    Logarithms(x, l);
    Sines(x, s);
    Arctangents(y, x, a);
    for (std::size_t i = 0; i < x.size(); ++i) {
      EXPECT_EQ(a[i], Arctangent(y[i], x[i]));
      if (i == 100) continue;
      EXPECT_EQ(e[i], Exponential(x[i]));
      EXPECT_EQ(s[i], SineToPi(x[i]));
      if (x[i] > 0) {
        EXPECT_EQ(l[i], Logarithm(x[i]));
      }
    }
    EXPECT_DOUBLE_EQ(e[100], std::exp(strange));
    if (strange > 0) {
      EXPECT_DOUBLE_EQ(l[100], std::log(strange));
    }
    if (std::isfinite(strange)) {
      EXPECT_DOUBLE_EQ(s[100], std::sin(strange));
    }
  }
  EXPECT_GT(e[0] + e[1], 20);
}

}  // namespace
}  // namespace cirque

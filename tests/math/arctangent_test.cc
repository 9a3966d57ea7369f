#include "cirque/math/arctangent.h"

#include <cmath>
#include <limits>
#include <random>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

namespace cirque {
namespace {

using Exact = boost::multiprecision::cpp_bin_float_50;

double Ulps(double y, double x) {
  const Exact exact = atan2(Exact(y), Exact(x));
  const double rounded = static_cast<double>(exact);
  const double ulp = std::nextafter(std::abs(rounded), 10.0) - std::abs(rounded);
  return std::abs(static_cast<double>((Exact(Arctangent(y, x)) - exact) / Exact(ulp)));
}

// Whatever the quadrant and the ratio, also where ranges of the reduction meet.
TEST(Arctangent, AgreesWithFiftyDigits) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> mantissa(-1, 1), exponent(-60, 60), angle(-kPi, kPi);
  double most = 0;
  for (int i = 0; i < 20000; ++i) {
    const double a = angle(random), scale = std::exp2(exponent(random));
    most = std::max(most, Ulps(scale * std::sin(a), scale * std::cos(a)));
    most = std::max(most, Ulps(mantissa(random) * std::exp2(exponent(random)), mantissa(random)));
  }
  for (int eighth = -8; eighth <= 8; ++eighth) {
    for (int step = -20; step <= 20; ++step) {
      const double a = eighth * kPi / 8 + step * 0x1p-52;
      most = std::max(most, Ulps(std::sin(a), std::cos(a)));
    }
  }
  EXPECT_LT(most, 2);
  EXPECT_GT(most, 0);
}

TEST(Arctangent, IsThatOfTheLibraryWhereSizesAreExtreme) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double y : {0.0, -0.0, 1.0, -1.0, 5e-324, 1e308, -kInfinity, kInfinity}) {
    for (const double x : {0.0, -0.0, 1.0, -1.0, -5e-324, -1e308, -kInfinity, kInfinity}) {
      EXPECT_DOUBLE_EQ(Arctangent(y, x), std::atan2(y, x)) << y << " " << x;
      EXPECT_EQ(std::signbit(Arctangent(y, x)), std::signbit(std::atan2(y, x))) << y << " " << x;
    }
  }
  EXPECT_TRUE(std::isnan(Arctangent(std::nan(""), 1)));
  EXPECT_TRUE(std::isnan(Arctangent(1, std::nan(""))));
}

}  // namespace
}  // namespace cirque

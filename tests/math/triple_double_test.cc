// Numbers of three times a double's digits against fifty digits.
#include "cirque/math/triple_double.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "experiments/common/high_precision.h"

namespace cirque {
namespace {

using high_precision::Real;

Real Exact(const TripleDouble& x) { return Real(x.high) + Real(x.middle) + Real(x.low); }

double Error(const TripleDouble& found, const Real& exact) {
  return static_cast<double>(abs(Exact(found) - exact));
}

class Draws {
 public:
  double operator()() { return std::ldexp(static_cast<double>(random_()), -32) - 0.5; }
  TripleDouble Number(double range) {
    const double high = range * (*this)(), middle = 1e-17 * range * (*this)();
    return SumOf(high, middle, 1e-34 * range * (*this)());
  }

 private:
  std::mt19937 random_{5};
};

TEST(TripleDouble, SumsDifferencesAndProductsHaveThreeTimesTheDigits) {
  Draws draw;
  for (int i = 0; i < 200; ++i) {
    const TripleDouble a = draw.Number(200), b = draw.Number(200);
    EXPECT_LT(Error(a + b, Exact(a) + Exact(b)), 1e-44);
    EXPECT_LT(Error(a - b, Exact(a) - Exact(b)), 1e-44);
    EXPECT_LT(Error(a * b, Exact(a) * Exact(b)), 1e-42);
    EXPECT_LT(Error(Half(a), Exact(a) / 2), 1e-47);
  }
  const TripleDouble near = TripleDouble(1) + 1e-40;
  EXPECT_EQ((near - 1.0).Value(), 1e-40);
  EXPECT_TRUE(TripleDouble(1) < near);
  EXPECT_FALSE(near < TripleDouble(1));
}

TEST(TripleDouble, QuotientsRootsAndExponentialsRelatively) {
  Draws draw;
  for (int i = 0; i < 200; ++i) {
    const TripleDouble a = draw.Number(200), b = draw.Number(200);
    const Real quotient = Exact(a) / Exact(b), exponential = exp(Exact(a)), square = Exact(a * a);
    EXPECT_LT(Error(a / b, quotient), 1e-45 * static_cast<double>(abs(quotient)));
    EXPECT_LT(Error(Exp(a), exponential), 1e-43 * static_cast<double>(exponential));
    EXPECT_LT(Error(Sqrt(a * a), sqrt(square)), 1e-45 * static_cast<double>(sqrt(square)));
  }
  EXPECT_EQ(Sqrt(0).Value(), 0);
}

TEST(TripleDouble, LogarithmsOfSumsToo) {
  Draws draw;
  for (int i = 0; i < 300; ++i) {
    const TripleDouble a = draw.Number(200);
    const TripleDouble b = a + draw.Number(i % 3 == 0 ? 1e-9 : i % 3 == 1 ? 90 : 2);
    const Real exact = log(exp(Exact(a)) + exp(Exact(b)));
    EXPECT_LT(Error(LogAddExp(a, b), exact), 1e-44) << i;
  }
}

}  // namespace
}  // namespace cirque

#include "cirque/math/clausen.h"

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <boost/math/constants/constants.hpp>
#include <gtest/gtest.h>

#include "cirque/core/types.h"
#include "cirque/math/clausen_coefficients.h"

#include "experiments/common/high_precision.h"

namespace cirque {
namespace {

using high_precision::Real;

double AbsoluteError(double x) {
  return static_cast<double>(abs(Real(Clausen(x)) - high_precision::Clausen(x)));
}

TEST(Clausen, KnownValues) {
  EXPECT_NEAR(Clausen(kPi / 2), boost::math::constants::catalan<double>(), 2.3e-16);
  EXPECT_NEAR(Clausen(kPi / 3), 1.0149416064096536250, 2.3e-16);
  EXPECT_EQ(Clausen(0.0), 0.0);
  EXPECT_NEAR(Lobachevsky(kPi / 6), 1.0149416064096536250 / 2, 2.3e-16);
}

/// The reference obeys what the framework's code never uses.
TEST(Clausen, ReferenceSatisfiesDuplicationAndSeries) {
  for (const double x : {1e-6, 0.3, 1.0, 1.5}) {
    const Real t = x;
    const Real duplicated = 2 * high_precision::Clausen(t) -
                            2 * high_precision::Clausen(Real(high_precision::Pi() - t));
    EXPECT_LT(abs(duplicated - high_precision::Clausen(Real(2 * t))), Real(1e-46));
  }
  const Real by_powers = high_precision::ImDilogByPowers(-2.25, 1.1);
  EXPECT_LT(abs(by_powers - high_precision::ImDilogByBernoulli(-2.25, 1.1)), Real(1e-45));
}

TEST(Clausen, TwoUlpOnOnePeriod) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0.0, 2 * kPi);
  double worst = 0.0;
  for (int i = 0; i < 4000; ++i) worst = std::max(worst, AbsoluteError(uniform(random)));
  // The seams of the three branches, the zeros, the extrema.
  for (const double centre : {0.0, kPi / 3, kPi / 2, kPi, 3 * kPi / 2, 5 * kPi / 3, 2 * kPi}) {
    for (const double step : {0.0, 1e-300, 1e-16, 1e-12, 1e-8, 1e-4, 1e-2}) {
      worst = std::max(worst, AbsoluteError(std::min(centre + step, 2 * kPi)));
      worst = std::max(worst, AbsoluteError(std::abs(centre - step)));
    }
  }
  RecordProperty("worst", std::to_string(worst * 0x1p52) + " * 2^-52");
  EXPECT_LE(worst, 0x1p-52);
}

TEST(Clausen, RelativelyAccurateAtItsZeros) {
  for (const double step : {1e-300, 1e-100, 1e-16, 1e-12, 1e-8, 1e-4, 1e-2}) {
    for (const double x : {step, kPi - step, kPi + step, 2 * kPi - step}) {
      EXPECT_LT(high_precision::RelativeError(Clausen(x), high_precision::Clausen(x)), 1e-15) << x;
    }
  }
}

TEST(Clausen, AnyRealArgument) {
  for (const double x : {6.3, 7.0, 12.566370614359172, 100.0, 1e3 * kPi, 999999.0, 1000001.0, 1e15,
                         0x1.921fb54442d18p+60}) {
    EXPECT_LT(AbsoluteError(x), 4e-16) << x;
    EXPECT_EQ(Clausen(-x), -Clausen(x));
  }
  EXPECT_TRUE(std::isnan(Clausen(std::numeric_limits<double>::infinity())));
  EXPECT_TRUE(std::isnan(Clausen(std::numeric_limits<double>::quiet_NaN())));
}

/// Monomial coefficients of the interpolant of f in the N Chebyshev nodes of [0, width].
template <std::size_t N, typename F>
std::array<Real, N> ChebyshevInterpolant(const F& f, const Real& width) {
  std::vector<Real> node(N), newton(N);
  for (std::size_t i = 0; i < N; ++i) {
    node[i] = width / 2 * (1 + cos(high_precision::Pi() * (2 * i + 1) / (2 * N)));
    newton[i] = f(node[i]);
  }
  for (std::size_t k = 1; k < N; ++k) {
    for (std::size_t i = N - 1; i >= k; --i) {
      newton[i] = (newton[i] - newton[i - 1]) / (node[i] - node[i - k]);
    }
  }
  std::array<Real, N> c = {};
  for (std::size_t k = N; k-- > 0;) {  // c <- c * (t - node[k]) + newton[k]
    for (std::size_t i = N - 1; i > 0; --i) c[i] = c[i - 1] - node[k] * c[i];
    c[0] = newton[k] - node[k] * c[0];
  }
  return c;
}

TEST(Clausen, CoefficientsAreTheChebyshevInterpolants) {
  const Real quarter = high_precision::Pi() / 2;
  const auto zero = ChebyshevInterpolant<kClausenNearZero.size()>(
      [](const Real& t) {
        const Real x = sqrt(t);
        return (high_precision::Clausen(x) - x + x * log(x)) / (x * t);
      },
      quarter * quarter);
  for (std::size_t i = 0; i < zero.size(); ++i) {
    EXPECT_LT(high_precision::RelativeError(kClausenNearZero[i], zero[i]), 2e-16) << i;
  }
  const auto pi = ChebyshevInterpolant<kClausenNearPi.size()>(
      [](const Real& t) {
        const Real y = sqrt(t);
        return (high_precision::Clausen(Real(high_precision::Pi() - y)) / y - log(Real(2))) / t;
      },
      quarter * quarter);
  for (std::size_t i = 0; i < pi.size(); ++i) {
    EXPECT_LT(high_precision::RelativeError(kClausenNearPi[i], pi[i]), 2e-16) << i;
  }
}

}  // namespace
}  // namespace cirque

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cirque/core/types.h"
#include "cirque/math/circle_angle.h"

#include "experiments/common/high_precision.h"

namespace cirque {
namespace {

using high_precision::Real;
using high_precision::RelativeError;

const std::vector<double> kThetas = {1e-12, 1e-9,       1e-4,       0.05,       0.3,
                                     1.0,   kPi / 3,    kPi / 2,    2.5,        3.0,
                                     3.14,  kPi - 1e-4, kPi - 1e-9, kPi - 1e-12};
const std::vector<double> kLogRatios = {0.0, 1e-15, 1e-9, 1e-4, 0.05, 0.3,
                                        1.0, 1.99,  2.01, 7.0,  40.0};

TEST(EdgePotential, AgreesWithTheDilogarithmsInFiftyDigits) {
  double worst = 0.0;
  for (const double theta : kThetas) {
    for (const double magnitude : kLogRatios) {
      for (const double d : {magnitude, -magnitude}) {
        const ScalarJet psi = EdgePotential(d, theta);
        const Real p = high_precision::Pi() - theta - 2 * high_precision::HalfAngle(d, theta);
        const double error = RelativeError(psi.value, high_precision::EdgePotential(d, theta));
        EXPECT_LT(error, 1e-13) << "d " << d << " theta " << theta;
        EXPECT_LT(RelativeError(psi.slope, d == 0.0 ? Real(0) : p), 2e-15)
            << "d " << d << " theta " << theta;
        EXPECT_EQ(psi.curvature, HalfAngleWeight(d, theta));
        worst = std::max(worst, error);
      }
    }
  }
  RecordProperty("worst", std::to_string(worst * 1e15) + "e-15");
}

/// The closed form printed in the literature, in 50 digits: the identity itself.
TEST(EdgePotential, ClosedFormIsTheSumOfTheDilogarithms) {
  for (const double theta : {1e-6, 0.4, 1.7, 3.1}) {
    for (const double d : {-5.0, -0.3, 0.0, 1e-5, 2.2}) {
      const Real star = high_precision::Pi() - theta;
      const Real p = 2 * atan(tanh(Real(d) / 2) * tan(star / 2));
      const Real closed = p * d + high_precision::Clausen(star + p) +
                          high_precision::Clausen(star - p) - high_precision::Clausen(2 * star);
      EXPECT_LT(abs(closed - high_precision::EdgePotential(d, theta)), Real(1e-42));
    }
  }
}

TEST(EdgePotential, IsLinearFarOut) {
  for (const double theta : kThetas) {
    const Real star = high_precision::Pi() - theta;
    EXPECT_LT(RelativeError(EdgePotential(1e4, theta).value, Real(1e4 * star)), 1e-15);
    EXPECT_EQ(EdgePotential(-1e4, theta).value, EdgePotential(1e4, theta).value);
    EXPECT_LT(RelativeError(EdgePotential(-1e4, theta).slope, Real(-star)), 1e-15);
  }
}

struct Angles {
  double i, j;
};

/// Balanced and lopsided pairs, theta and theta* down to 1e-12, obtuse angles.
std::vector<Angles> FragileAngles() {
  std::vector<Angles> pairs;
  for (const double a : {1e-12, 1e-6, 1e-3, 0.1, kPi / 3, 1.5, 2.0, kPi - 1e-3}) {
    for (const double b : {1e-12, 1e-7, 1e-3, 0.2, kPi / 3, 2.5}) {
      if (a + b < kPi - 1e-9) pairs.push_back({a, b});
    }
    for (const double theta : {1e-12, 1e-8, 1e-3, 0.06, 0.07}) {
      if (a < kPi - theta) pairs.push_back({a, kPi - a - theta});
    }
  }
  std::erase_if(pairs, [](const Angles& p) { return std::min(p.i, p.j) < 9e-13; });
  return pairs;
}

/// The error of d - d_e that rounding d_e entails, relatively; E is quadratic near d_e.
double OffsetError(double d, double minimum) {
  const double offset = std::abs(d - minimum);
  return 4.0 * 0x1p-52 * std::max(std::abs(minimum), std::abs(d)) / std::max(offset, 1e-300);
}

void ExpectExcessAccurate(double d, const Angles& a) {
  const Real minimum = high_precision::MinimalLogRatio(a.i, a.j);
  const Real expected = high_precision::EdgeExcess(d, a.i, a.j);
  if (expected < Real(1e-35)) return;  // the reference itself cancels there
  const Real theta = high_precision::Pi() - a.i - a.j;
  const Real slope = 2 * (a.i - high_precision::HalfAngle(d, theta));
  const Real r = (Real(d) < minimum ? -1 : 1) * sqrt(2 * expected);
  const double tolerance = 1e-10 + 2.0 * OffsetError(d, static_cast<double>(minimum));
  const ScalarJet excess = EdgeExcess(d, a.i, a.j);
  const ResidualJet residual = EdgeResidual(d, a.i, a.j);
  const auto where = ::testing::Message() << "d " << d << " alpha " << a.i << " " << a.j
                                          << " offset " << Real(d - minimum);
  EXPECT_LT(RelativeError(excess.value, expected), tolerance) << where;
  EXPECT_LT(RelativeError(excess.slope, slope), tolerance) << where;
  EXPECT_LT(RelativeError(residual.value, r), tolerance) << where;
  EXPECT_LT(RelativeError(residual.slope, Real(slope / r)), tolerance) << where;
  EXPECT_LT(RelativeError(excess.curvature, high_precision::HalfAngleWeight(d, theta)), 1e-11)
      << where;
}

TEST(EdgeExcess, AgreesWithFiftyDigitsAtFragilePoints) {
  for (const Angles& a : FragileAngles()) {
    const double minimum = MinimalLogRatio(a.i, a.j);
    for (const double scale : {1e-9, 1e-5, 0.03, 0.4, 1.0, 1.5, 4.0, 30.0}) {
      // Offsets on the scale of the weight's peak, theta, and on the scale 1.
      for (const double offset : {scale, scale * CircleAngle::FromCorners(a.i, a.j).theta}) {
        ExpectExcessAccurate(minimum + offset, a);
        ExpectExcessAccurate(minimum - offset, a);
      }
    }
    ExpectExcessAccurate(0.0, a);
  }
}

TEST(EdgeExcess, AgreesWithFiftyDigitsAtRandomPoints) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int i = 0; i < 1000; ++i) {
    const double u = kPi * uniform(random), v = kPi * uniform(random);
    const Angles a = u + v < kPi ? Angles{u, v} : Angles{kPi - u, kPi - v};
    ExpectExcessAccurate(8.0 * uniform(random) - 4.0, a);
  }
}

TEST(EdgeExcess, MinimumIsWhereTheHalfAnglesAreTheCoherentOnes) {
  for (const Angles& a : FragileAngles()) {
    const double minimum = MinimalLogRatio(a.i, a.j), slack = 1e-13 + 1e-15 * std::abs(minimum);
    const CircleAngle theta = CircleAngle::FromCorners(a.i, a.j);
    EXPECT_NEAR(HalfAngle(minimum, theta) / a.i, 1.0, slack);
    EXPECT_NEAR(HalfAngle(-minimum, theta) / a.j, 1.0, slack);
    const ResidualJet r = EdgeResidual(minimum, a.i, a.j);
    EXPECT_NEAR(r.slope / std::sqrt(HalfAngleWeight(minimum, theta)), 1.0, 1e-9);
    EXPECT_EQ(r.value, 0.0);
  }
}

TEST(EdgeExcess, HugeRatiosStayFinite) {
  for (const Angles& a : FragileAngles()) {
    for (const double d : {-1e4, 1e4}) {
      const ScalarJet e = EdgeExcess(d, a.i, a.j);
      EXPECT_NEAR(e.value / (std::abs(d) * 2.0 * (d > 0 ? a.i : a.j)), 1.0, 0.02);
      EXPECT_NEAR(std::abs(EdgeResidual(d, a.i, a.j).value) / std::sqrt(2.0 * e.value), 1.0, 1e-15);
    }
  }
}

TEST(EdgeExcess, ExchangingTheFacesMirrorsIt) {
  for (const double d : {-2.0, 0.01, 0.4, 5.0}) {
    EXPECT_EQ(EdgeExcess(d, 0.4, 1.1).value, EdgeExcess(-d, 1.1, 0.4).value);
    EXPECT_EQ(EdgeResidual(d, 0.4, 1.1).value, -EdgeResidual(-d, 1.1, 0.4).value);
    EXPECT_EQ(EdgeResidual(d, 0.4, 1.1).slope, EdgeResidual(-d, 1.1, 0.4).slope);
  }
}

}  // namespace
}  // namespace cirque

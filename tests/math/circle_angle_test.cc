#include "cirque/math/circle_angle.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "cirque/core/types.h"

#include "experiments/common/high_precision.h"

namespace cirque {
namespace {

using high_precision::Real;

const std::vector<double> kThetas = {1e-12, 1e-9,       1e-4,           0.3,
                                     1.0,   kPi / 2,    kPi / 2 + 1e-9, 2.5,
                                     3.14,  kPi - 1e-4, kPi - 1e-9,     kPi - 1e-12};
const std::vector<double> kLogRatios = {0.0, 1e-300, 1e-15, 1e-12, 1e-9,  1e-4, 0.3,
                                        1.0, 3.0,    20.0,  50.0,  300.0, 650.0};

TEST(CircleAngle, HalfAngleAgreesWithFiftyDigits) {
  for (const double theta : kThetas) {
    for (const double magnitude : kLogRatios) {
      for (const double d : {magnitude, -magnitude}) {
        const Real phi = high_precision::HalfAngle(d, theta);
        EXPECT_LT(high_precision::RelativeError(HalfAngle(d, theta), phi), 1e-15)
            << "d " << d << " theta " << theta;
        const Real weight = high_precision::HalfAngleWeight(d, theta);
        EXPECT_LT(high_precision::RelativeError(HalfAngleWeight(d, theta), weight), 2e-15)
            << "d " << d << " theta " << theta;
      }
    }
  }
}

TEST(CircleAngle, RandomAgreesWithFiftyDigits) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> angle(0.0, kPi), ratio(-30.0, 30.0);
  for (int i = 0; i < 2000; ++i) {
    const double theta = angle(random), d = ratio(random) * (i % 2 == 0 ? 1.0 : 0.1);
    const Real phi = high_precision::HalfAngle(d, theta);
    EXPECT_LT(high_precision::RelativeError(HalfAngle(d, theta), phi), 1e-15);
    const Real weight = high_precision::HalfAngleWeight(d, theta);
    EXPECT_LT(high_precision::RelativeError(HalfAngleWeight(d, theta), weight), 2e-15);
  }
}

TEST(CircleAngle, TailIsExponentialWhereNothingUnderflows) {
  EXPECT_DOUBLE_EQ(HalfAngle(700.0, 1.0), std::exp(-700.0) * std::sin(1.0));
  EXPECT_GT(HalfAngle(720.0, 1.0), 0.0);  // e^d has overflowed long ago
}

TEST(CircleAngle, NoOverflowForHugeRatios) {
  for (const double theta : kThetas) {
    EXPECT_EQ(HalfAngle(1e4, theta), 0.0);
    EXPECT_NEAR(HalfAngle(-1e4, theta), kPi - theta, 1e-15);
    EXPECT_EQ(HalfAngleWeight(1e4, theta), 0.0);
    EXPECT_EQ(HalfAngleWeight(-1e4, theta), 0.0);
  }
}

TEST(CircleAngle, TheTwoHalvesShareThetaStar) {
  for (const double theta : kThetas) {
    for (const double d : kLogRatios) {
      EXPECT_NEAR(HalfAngle(d, theta) + HalfAngle(-d, theta), kPi - theta, 1e-15);
    }
  }
}

/// A triangle's law of sines: circles of radii e^{rho} through an edge of length 2 e^{rho_i} sin
/// phi_i.
TEST(CircleAngle, BothFacesSeeTheSameEdgeLength) {
  for (const double theta : {0.3, 1.0, 2.0, 3.0}) {
    for (const double d : {-3.0, -0.2, 0.0, 1.5}) {
      EXPECT_NEAR(std::exp(d) * std::sin(HalfAngle(d, theta)), std::sin(HalfAngle(-d, theta)),
                  2e-15);
    }
  }
}

}  // namespace
}  // namespace cirque

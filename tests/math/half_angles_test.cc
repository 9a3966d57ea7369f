#include "cirque/math/half_angles.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "cirque/core/types.h"
#include "cirque/math/circle_angle.h"

namespace cirque {
namespace {

// To the last bit, whatever stands beside an edge: the shares of two ranks add up to the whole.
TEST(HalfAngles, AreThoseOfSingleEdges) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> log_ratio(0, 3);
  std::uniform_real_distribution<double> exterior(1e-12, kPi - 1e-12);
  std::vector<double> d, sine, one_minus_cosine;
  std::vector<CircleAngle> angle;
  for (int i = 0; i < 1001; ++i) {
    angle.push_back(CircleAngle::FromExterior(exterior(random)));
    d.push_back(i % 97 == 5 ? 1e4 : log_ratio(random));
    if (i % 211 == 3) d.back() = -2000;
    if (i % 131 == 7) angle.back() = CircleAngle::FromExterior(1e-250);
    sine.push_back(angle.back().sine);
    one_minus_cosine.push_back(angle.back().one_minus_cosine);
  }
  std::vector<double> phi(d.size()), weight(d.size());
  HalfAngles(d, sine, one_minus_cosine, phi);
  HalfAngleWeights(d, sine, one_minus_cosine, weight);
  for (std::size_t i = 0; i < d.size(); ++i) {
    EXPECT_EQ(phi[i], HalfAngle(d[i], angle[i])) << d[i];
    EXPECT_EQ(weight[i], HalfAngleWeight(d[i], angle[i])) << d[i];
    EXPECT_NEAR(phi[i] + HalfAngle(-d[i], angle[i]), kPi - angle[i].theta, 1e-14);
  }
}

// Also where theta or theta* is tiny: relative errors of a few last places.
TEST(HalfAngles, IntersectionAnglesAreThoseOfSingleEdges) {
  std::vector<double> alpha_i, alpha_j;
  for (const double a : {1e-9, 1e-3, 0.4, 1.2, 2.0, 3.0}) {
    for (const double b : {1e-9, 1e-6, 0.1, 0.5, 1.0, kPi - a - 1e-3, kPi - a - 1e-8}) {
      if (!(b > 0 && a + b < kPi)) continue;
      alpha_i.push_back(a);
      alpha_j.push_back(b);
    }
  }
  std::vector<CircleAngle> angle(alpha_i.size());
  CircleAngles(alpha_i, alpha_j, angle);
  EXPECT_GT(angle.size(), 30u);
  for (std::size_t i = 0; i < angle.size(); ++i) {
    const CircleAngle single = CircleAngle::FromCorners(alpha_i[i], alpha_j[i]);
    EXPECT_EQ(angle[i].theta, single.theta);
    EXPECT_NEAR(angle[i].sine / single.sine, 1, 1e-15);
    EXPECT_NEAR(angle[i].one_minus_cosine / single.one_minus_cosine, 1, 1e-15);
  }
}

TEST(HalfAngles, GiveTheValueOfThePotential) {
  for (const double theta : {1e-9, 0.3, 2.0, 3.1}) {
    for (const double d : {-20.0, -0.4, 0.0, 1e-9, 3.0}) {
      const double value = EdgePotentialValue(d, theta, HalfAngle(d, theta), HalfAngle(-d, theta));
      EXPECT_EQ(value, EdgePotential(d, theta).value);
      EXPECT_NEAR(value, EdgePotentialValue(-d, theta, HalfAngle(-d, theta), HalfAngle(d, theta)),
                  1e-14 * std::abs(value));
      EXPECT_GT(value, 0);
    }
  }
}

}  // namespace
}  // namespace cirque

// Triangles from the logarithms of their sides, against fifty digits and at what no length holds.
#include "cirque/math/log_triangle.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "cirque/core/types.h"

#include "experiments/common/high_precision.h"

namespace cirque {
namespace {

using high_precision::Real;

/// The angle opposite side 0 by the law of cosines.
Real AngleOpposite(double a, double b, double c) {
  const Real x = exp(Real(a)), y = exp(Real(b)), z = exp(Real(c));
  return acos((y * y + z * z - x * x) / (2 * y * z));
}

TEST(LogTriangle, AnglesAreThoseOfTheLawOfCosines) {
  std::mt19937 random(3);
  const auto draw = [&] { return std::ldexp(static_cast<double>(random()), -32); };
  int proper = 0;
  for (int i = 0; i < 200; ++i) {
    const double a = draw(), b = a - std::pow(draw(), 4), c = a - 2 * draw();
    const LogTriangle triangle = SolveLogTriangle({a, b, c});
    if (!triangle.proper) {
      EXPECT_GE(std::exp(a), std::exp(b) + std::exp(c) - 1e-15);
      continue;
    }
    ++proper;
    EXPECT_LT(high_precision::RelativeError(triangle.angle[0], AngleOpposite(a, b, c)), 1e-12);
    EXPECT_LT(high_precision::RelativeError(triangle.angle[1], AngleOpposite(b, c, a)), 1e-12);
    EXPECT_LT(high_precision::RelativeError(triangle.angle[2], AngleOpposite(c, a, b)), 1e-12);
    for (int k = 0; k < 3; ++k) {
      const double cotangent = 1 / std::tan(triangle.angle[k]);
      EXPECT_NEAR(triangle.Cotangent(k), cotangent, 1e-13 * (1 + std::pow(cotangent, 2)));
    }
  }
  EXPECT_GT(proper, 100);
}

TEST(LogTriangle, NeedlesHaveTheirAnglesInDigitsBelowADoubles) {
  // Sides a, a - d, c: the angle at the short side is arccos(d / c) but for d and c squared.
  for (const double log_short : {-20.0, -45.0, -60.0, -80.0}) {
    const double share = 0.25, difference = share * std::exp(log_short);
    const LogTriangle triangle = SolveExtendedLogTriangle(
        {TripleDouble(30), TripleDouble(30) - difference, TripleDouble(30 + log_short)});
    ASSERT_TRUE(triangle.proper);
    EXPECT_NEAR(triangle.angle[1], std::acos(share), 4e-9);
    EXPECT_NEAR(triangle.angle[0], kPi - std::acos(share), 4e-9);
  }
}

TEST(LogTriangle, AnglesAllButPiToo) {
  // Sides 1, 1 and 2 cos(t / 2), the angle opposite which is pi - t.
  for (const double t : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const TripleDouble log_long =
        LogAddExp(TripleDouble(0), 0) - (t * t / 8 + std::pow(t, 4) / 192);
    const LogTriangle triangle = SolveExtendedLogTriangle({log_long, 0, 0});
    ASSERT_TRUE(triangle.proper) << t;
    EXPECT_NEAR(triangle.half_tangent[0] * (0.5 * t), 1, 1e-6) << t;
    for (const int k : {1, 2}) EXPECT_NEAR(triangle.angle[k] / (0.5 * t), 1, 1e-6) << t;
  }
  const TripleDouble too_long = LogAddExp(TripleDouble(0), 0) + 1e-40;
  EXPECT_FALSE(SolveExtendedLogTriangle({too_long, 0, 0}).proper);
}

TEST(LogTriangle, EverySideIsTreatedAlike) {
  const LogTriangle t = SolveLogTriangle({0.1, 0.3, -0.2});
  const LogTriangle turned = SolveLogTriangle({0.3, -0.2, 0.1});
  const LogTriangle mirrored = SolveLogTriangle({0.3, 0.1, -0.2});
  EXPECT_EQ(t.angle[1], turned.angle[0]);
  EXPECT_EQ(t.angle[2], turned.angle[1]);
  EXPECT_EQ(t.angle[0], mirrored.angle[1]);
}

TEST(LogTriangle, NoScaleAndNoRatioIsTooLarge) {
  for (const double scale : {-1e5, 0.0, 1e5}) {
    const LogTriangle equilateral = SolveLogTriangle({scale, scale, scale});
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(equilateral.angle[k], kPi / 3, 1e-15);
    const LogTriangle needle = SolveLogTriangle({scale, scale, scale - 2000});
    EXPECT_TRUE(needle.proper);
    EXPECT_NEAR(needle.angle[0], kPi / 2, 1e-15);
    EXPECT_EQ(needle.angle[2], 0);
    EXPECT_TRUE(std::isfinite(needle.Cotangent(2)));
  }
}

TEST(LogTriangle, WhatIsNoneIsDegenerate) {
  for (const double longest : {std::log(2.0) + 1e-12, 3.0, 5000.0}) {
    const LogTriangle none = SolveLogTriangle({0, longest, 0});
    EXPECT_FALSE(none.proper);
    EXPECT_EQ(none.angle[0], 0);
    EXPECT_EQ(none.angle[1], kPi);
    EXPECT_EQ(none.Cotangent(1), 0);
  }
  EXPECT_TRUE(SolveLogTriangle({0, std::log(2.0) - 1e-12, 0}).proper);
}

TEST(LogAddExp, IsTheLogarithmOfTheSum) {
  EXPECT_NEAR(LogAddExp(std::log(2.0), std::log(3.0)), std::log(5.0), 1e-15);
  EXPECT_EQ(LogAddExp(-5000, 3), 3);
  EXPECT_NEAR(LogAddExp(7000, 7000), 7000 + std::log(2.0), 1e-12);
}

}  // namespace
}  // namespace cirque

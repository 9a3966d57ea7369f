#include "cirque/math/closed_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cirque {
namespace {

using Eigen::Vector2d;
using ::testing::HasSubstr;
constexpr double kPi = std::numbers::pi;

const std::vector<Vector2d> kRectangle = {{0, 0}, {3, 0}, {3, 1}, {0, 1}};

std::string Refusal(std::vector<Vector2d> points) {
  const StatusOr<ClosedCurve> curve = ClosedCurve::Through(std::move(points));
  EXPECT_EQ(curve.status().code(), StatusCode::kInvalidInput);
  return curve.status().message();
}

TEST(ClosedCurve, RunsAlongItsSides) {
  const ClosedCurve curve = *ClosedCurve::Through(kRectangle);
  EXPECT_EQ(curve.length(), 8);
  EXPECT_EQ(curve.Area(), 3);
  EXPECT_EQ(curve.At(0), Vector2d(0, 0));
  EXPECT_EQ(curve.At(3.5), Vector2d(3, 0.5));
  EXPECT_EQ(curve.At(7.25), Vector2d(0, 0.75));
  EXPECT_EQ(curve.At(-0.25), Vector2d(0, 0.25));
  EXPECT_EQ(curve.At(8 + 3), Vector2d(3, 0));
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(curve.TurningAt(k), kPi / 2, 1e-15);
}

TEST(ClosedCurve, IsCounterClockwiseWhicheverWayItIsGiven) {
  const std::vector<Vector2d> reversed = {{0, 0}, {0, 1}, {3, 1}, {3, 0}, {0, 0}};
  const ClosedCurve curve = *ClosedCurve::Through(reversed);
  EXPECT_EQ(curve.points(), kRectangle);
  EXPECT_EQ(curve.Area(), 3);
}

TEST(ClosedCurve, TurnsOnceHoweverItWinds) {
  std::vector<Vector2d> points;
  for (int k = 0; k < 200; ++k) {
    const double angle = 2 * kPi * k / 200, radius = 1 + 0.4 * std::cos(5 * angle);
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  const ClosedCurve star = *ClosedCurve::Through(points);
  double turned = 0, back = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    turned += star.TurningAt(k);
    back += std::min(0.0, star.TurningAt(k));
  }
  EXPECT_NEAR(turned, 2 * kPi, 1e-12);
  EXPECT_LT(back, -1);
}

TEST(ClosedCurve, AnEllipseHasItsAreaAndItsPerimeter) {
  const ClosedCurve ellipse = Ellipse(2, 1440);
  EXPECT_NEAR(ellipse.Area(), 2 * kPi, 2e-5);
  EXPECT_NEAR(ellipse.length(), 9.688448220547675, 2e-5);  // 8 E(3/4), Legendre's second integral
  EXPECT_EQ(ellipse.At(0), Vector2d(2, 0));
}

TEST(ClosedCurve, RefusesWhatIsNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(Refusal({{0, 0}, {1, 0}}), HasSubstr("three points or more"));
  EXPECT_THAT(Refusal({{0, 0}, {1, 0}, {nan, 1}}), HasSubstr("point 3 of the curve is not finite"));
  EXPECT_THAT(Refusal({{0, 0}, {1, 0}, {1, 0}, {0, 1}}), HasSubstr("points 2 and 3"));
  EXPECT_THAT(Refusal({{0, 0}, {1, 0}, {2, 0}}), HasSubstr("meets itself"));
  EXPECT_THAT(Refusal({{0, 0}, {1e-170, 0}, {0, 1e-170}}), HasSubstr("scale the curve"));
  EXPECT_THAT(Refusal({{0, 0}, {1e170, 0}, {0, 1e170}}), HasSubstr("scale the curve"));
  // So thin that the sign of its area is one of rounding errors.
  EXPECT_THAT(Refusal({{0, 0}, {0x1p60, 0x1p60}, {0x1p61 + 512, 0x1p61}}),
              HasSubstr("no area beyond rounding"));
}

TEST(ClosedCurve, NamesTheSidesThatMeetAsTheyWereGiven) {
  // The second side crosses the fourth.
  const std::vector<Vector2d> crossing = {{0, 0}, {4, 0}, {1, 3}, {3, 3}};
  EXPECT_THAT(Refusal(crossing), HasSubstr("points 2 and 4"));
  const std::vector<Vector2d> reversed = {{0, 0}, {3, 3}, {1, 3}, {4, 0}};
  EXPECT_THAT(Refusal(reversed), HasSubstr("points 1 and 3"));
}

}  // namespace
}  // namespace cirque

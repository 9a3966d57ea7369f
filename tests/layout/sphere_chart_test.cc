#include "cirque/layout/sphere_chart.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "cirque/math/moebius.h"

namespace cirque {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

class SphereChartTest : public ::testing::Test {
 protected:
  std::vector<Vector2d> Points(int count) {
    std::vector<Vector2d> points;
    for (int i = 0; i < count; ++i) points.emplace_back(normal_(random_), normal_(random_));
    return points;
  }

  static std::vector<Vector3d> Lift(const SphereChart& chart, const std::vector<Vector2d>& plane) {
    std::vector<Vector3d> points;
    for (const Vector2d& z : plane) points.push_back(chart.Lift(z));
    return points;
  }

  /// Equal up to a rotation (or reflection): all distances agree.
  static void ExpectCongruent(const std::vector<Vector3d>& a, const std::vector<Vector3d>& b,
                              double tolerance) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_NEAR((a[i] - a[j]).norm(), (b[i] - b[j]).norm(), tolerance) << i << " " << j;
      }
    }
  }

  std::mt19937_64 random_{5};
  std::normal_distribution<double> normal_;
};

TEST_F(SphereChartTest, IsTheStereographicProjection) {
  const SphereChart chart{{1, 2}, 0.5};
  EXPECT_EQ(chart.Lift({1, 2}), Vector3d(0, 0, 1));
  EXPECT_LT((chart.Lift({1.5, 2}) - Vector3d(1, 0, 0)).norm(), 1e-16);
  EXPECT_LT((chart.Lift({1, 2.5}) - Vector3d(0, 1, 0)).norm(), 1e-16);
  EXPECT_LT((chart.Lift({1, 3}) - Vector3d(0, 0.8, -0.6)).norm(), 1e-15);
}

TEST_F(SphereChartTest, FarPointsComeToInfinityWithoutOverflow) {
  const SphereChart chart;
  for (const double far : {1e8, 1e100, 1e200, 1e300}) {
    const Vector3d x = chart.Lift({far, 0});
    EXPECT_NEAR(x.x() * far, 2, 1e-13);
    EXPECT_NEAR(x.z(), -1, 1e-15);
  }
}

TEST_F(SphereChartTest, RecentringIsABoostUpToARotation) {
  const SphereChart chart{{0.3, -0.2}, 1.7};
  const std::vector<Vector2d> plane = Points(30);
  for (const Vector3d& x : {Vector3d(0.5, 0, 0), Vector3d(0, 0, -0.9), Vector3d(-0.4, 0.6, 0.5)}) {
    const LorentzBoost boost(x);
    std::vector<Vector3d> boosted;
    for (const Vector3d& v : Lift(chart, plane)) boosted.push_back(boost(v));
    ExpectCongruent(Lift(chart.Recentred(boost.centre()), plane), boosted, 1e-13);
  }
}

TEST_F(SphereChartTest, ASequenceOfBoostsIsOneRecentring) {
  const SphereChart chart;
  const std::vector<Vector2d> plane = Points(30);
  const std::vector<LorentzBoost> boosts = {
      LorentzBoost({0.5, 0.1, 0}), LorentzBoost({0, -0.8, 0.3}), LorentzBoost({0.2, 0.2, -0.7})};
  std::vector<Vector3d> points = Lift(chart, plane), centres;
  for (const LorentzBoost& boost : boosts) {
    for (Vector3d& v : points) v = boost(v);
    centres.push_back(boost.centre());
  }
  ExpectCongruent(Lift(chart.Recentred(CentreOfBoosts(centres)), plane), points, 1e-13);
}

TEST_F(SphereChartTest, ACrowdSeenFromItsOwnWindowKeepsItsShape) {
  const std::vector<Vector2d> plane = Points(20);
  std::vector<Vector2d> crowd;
  for (const Vector2d& z : plane) crowd.push_back(1e-200 * z);
  ExpectCongruent(Lift(SphereChart{{0, 0}, 1e-200}, crowd), Lift(SphereChart(), plane), 1e-14);
}

TEST_F(SphereChartTest, TheBalancedChartIgnoresOutliers) {
  std::vector<Vector2d> plane = {{0, 0}, {2, 0}, {1, 1}, {1, -1}, {1, 0}};
  plane.emplace_back(1e12, -1e12);
  const SphereChart chart = BalancedChart(plane, {1, 1, 1, 1, 1, 0.1});
  EXPECT_EQ(chart.centre, Vector2d(1, 0));
  EXPECT_EQ(chart.scale, 1);
  EXPECT_GT(BalancedChart({{3, 3}}, {1}).scale, 0);
}

}  // namespace
}  // namespace cirque

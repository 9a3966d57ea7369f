#include "cirque/generators/surface_chart.h"

#include <cmath>

#include <gtest/gtest.h>

namespace cirque {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

TEST(UniformRandom, IsTheStandardsEngineInTheUnitInterval) {
  // The standard fixes the 10000th output of mt19937_64 with its default seed, 5489.
  UniformRandom random(5489);
  double value = 0;
  for (int i = 0; i < 10000; ++i) {
    value = random();
    ASSERT_GE(value, 0);
    ASSERT_LT(value, 1);
  }
  EXPECT_EQ(value, static_cast<double>(9981545732273789042ULL >> 11) * 0x1p-53);
}

TEST(UniformRandom, FillsAnInterval) {
  UniformRandom random(3);
  double sum = 0, least = 10, greatest = -10;
  constexpr int kCount = 100000;
  for (int i = 0; i < kCount; ++i) {
    const double x = random(-2, 5);
    sum += x;
    least = std::min(least, x);
    greatest = std::max(greatest, x);
  }
  EXPECT_NEAR(sum / kCount, 1.5, 0.03);
  EXPECT_NEAR(least, -2, 1e-3);
  EXPECT_NEAR(greatest, 5, 1e-3);
}

/// The rectangle [0, 2] x [0, 1], edges twice as long in its right half.
SurfaceChart Rectangle() {
  SurfaceChart chart;
  chart.position = [](double a, double b) { return Vector2d(2 * a, b); };
  chart.lift = [](const Vector2d& p) { return Vector3d(p.x(), p.y(), 0); };
  chart.flatten = [](const Vector3d& p) { return Vector2d(p.head<2>()); };
  chart.spacing = [](const Vector3d& p) { return p.x() < 1 ? 1.0 : 2.0; };
  chart.allowed = [](const Vector2d& p, double) { return p.y() > 0.1; };
  chart.boundary = {[](double t) { return Vector2d(2 * t, 0); }};
  chart.triangulate = TriangulateHull;
  return chart;
}

TEST(ChartSampler, MassIsTheIntegralOfTheDensity) {
  const SurfaceChart chart = Rectangle();
  EXPECT_NEAR(ChartSampler(chart, 1).Mass(), 1 + 1 / 4.0, 1e-12);
}

TEST(ChartSampler, InteriorPointsFollowTheDensityWhereTheyMayBe) {
  const SurfaceChart chart = Rectangle();
  const std::vector<Vector2d> points = ChartSampler(chart, 1).Interior(5000, 0.02);
  ASSERT_EQ(points.size(), 5000u);
  int left = 0;
  for (const Vector2d& p : points) {
    EXPECT_GT(p.y(), 0.1);
    EXPECT_LE(p.y(), 1);
    EXPECT_GE(p.x(), 0);
    EXPECT_LE(p.x(), 2);
    left += p.x() < 1 ? 1 : 0;
  }
  // Four points in five, of a sequence whose discrepancy is far below that of random points.
  EXPECT_NEAR(left, 4000, 40);
}

TEST(ChartSampler, BoundaryPointsAreASpacingApart) {
  const SurfaceChart chart = Rectangle();
  const std::vector<Vector2d> points = ChartSampler(chart, 1).Boundary(0.01);
  // 1 / 0.01 steps in the left half, 1 / 0.02 in the right one.
  ASSERT_EQ(points.size(), 150u);
  EXPECT_EQ(points[0], Vector2d(0, 0));
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double step = points[i].x() - points[i - 1].x();
    const double spacing = points[i].x() <= 1 ? 0.01 : points[i - 1].x() >= 1 ? 0.02 : 0.015;
    EXPECT_NEAR(step, spacing, 0.5 * spacing) << i;
  }
}

TEST(ChartSampler, APieceHasItsLeastNumberOfVertices) {
  SurfaceChart chart = Rectangle();
  chart.min_boundary_vertices = 7;
  EXPECT_EQ(ChartSampler(chart, 1).Boundary(100).size(), 7u);
}

TEST(SoupOfTriangles, RenumbersAndLeavesOutUnnamedPoints) {
  const std::vector<Vector3d> points = {{0, 0, 0}, {1, 0, 0}, {9, 9, 9}, {0, 1, 0}, {1, 1, 0}};
  const PolygonSoup soup = SoupOfTriangles(points, {{4, 3, 1}, {0, 1, 3}});
  EXPECT_EQ(soup.corner, (std::vector<Index>{0, 1, 2, 3, 2, 1}));
  EXPECT_EQ(soup.first_corner, (std::vector<Index>{0, 3, 6}));
  EXPECT_EQ(soup.position, (std::vector<Vector3d>{{1, 1, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}}));
}

}  // namespace
}  // namespace cirque

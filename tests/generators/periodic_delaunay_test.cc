#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "cirque/generators/planar_delaunay.h"
#include "cirque/generators/surface_chart.h"
#include "cirque/math/predicates.h"

namespace cirque {
namespace {

using Eigen::Vector2d;

struct Cell {
  std::vector<Vector2d> points;
  Vector2d periods;
};

Cell RandomCell(Index count, const Vector2d& periods, unsigned seed) {
  UniformRandom random(seed);
  Cell cell{{}, periods};
  for (Index i = 0; i < count; ++i) {
    const double x = random(-0.5, 0.5), y = random(-0.5, 0.5);
    cell.points.emplace_back(x * periods.x(), y * periods.y());
  }
  return cell;
}

/// The translate of point v that lies nearest to `here`.
Vector2d NearestTranslate(const Cell& cell, Index v, const Vector2d& here) {
  Vector2d p = cell.points[v];
  for (int k = 0; k < 2; ++k) {
    p[k] += cell.periods[k] * std::round((here[k] - p[k]) / cell.periods[k]);
  }
  return p;
}

std::array<Vector2d, 3> Unrolled(const Cell& cell, const Triangle& t) {
  const Vector2d a = cell.points[t[0]];
  return {a, NearestTranslate(cell, t[1], a), NearestTranslate(cell, t[2], a)};
}

class PeriodicDelaunayTest : public testing::TestWithParam<unsigned> {
 protected:
  PeriodicDelaunayTest()
      : cell_(RandomCell(400, Vector2d(3, 2), GetParam())),
        triangles_(PeriodicDelaunay(cell_.points, cell_.periods)) {}

  const Cell cell_;
  const std::vector<Triangle> triangles_;
};

TEST_P(PeriodicDelaunayTest, IsATorusOfTheCellsArea) {
  EXPECT_EQ(triangles_.size(), 2 * cell_.points.size());  // V - E + F = 0, 3 F = 2 E
  std::map<std::pair<Index, Index>, int> directed;
  double area = 0;
  for (const Triangle& t : triangles_) {
    const auto [a, b, c] = Unrolled(cell_, t);
    EXPECT_GT(OrientationSign(a, b, c), 0);
    area += ((b - a).x() * (c - a).y() - (b - a).y() * (c - a).x()) / 2;
    for (std::size_t k = 0; k < 3; ++k) ++directed[{t[k], t[(k + 1) % 3]}];
  }
  EXPECT_NEAR(area, cell_.periods.prod(), 1e-12);
  for (const auto& [edge, count] : directed) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(directed.count({edge.second, edge.first}), 1u);
  }
}

TEST_P(PeriodicDelaunayTest, NoTranslateLiesInACircumcircle) {
  for (const Triangle& t : triangles_) {
    const auto [a, b, c] = Unrolled(cell_, t);
    for (const Vector2d& p : cell_.points) {
      for (int i = -1; i <= 1; ++i) {
        for (int j = -1; j <= 1; ++j) {
          const Vector2d moved = p + Vector2d(i, j).cwiseProduct(cell_.periods);
          const bool is_corner = (moved - a).norm() < 1e-12 || (moved - b).norm() < 1e-12 ||
                                 (moved - c).norm() < 1e-12;
          ASSERT_TRUE(is_corner || InCircleSign(a, b, c, moved) <= 0);
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, PeriodicDelaunayTest, testing::Values(1u, 2u, 3u));

}  // namespace
}  // namespace cirque

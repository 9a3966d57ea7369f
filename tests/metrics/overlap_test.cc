#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/metrics/maps.h"

namespace cirque {
namespace {

using Eigen::Vector2d;
using Triangle = std::array<Vector2d, 3>;

TEST(Overlap, AFoldedSheetLiesOnItself) {
  for (const auto& [layers, columns] : {std::pair{2, 4}, {3, 6}, {5, 10}}) {
    const double width = static_cast<double>(columns) / layers;
    const auto fold = [&](const Eigen::Vector3d& p) {
      const double x = std::fmod(p.x(), 2 * width);
      return Vector2d(std::min(x, 2 * width - x), p.y());
    };
    const MapMeasures m = MapOf(Grid(columns, 3), fold).Measure();
    EXPECT_NEAR(m.ValueOf("overlap_area"), 1 - 1.0 / layers, 1e-13) << layers;
    EXPECT_NEAR(m.ValueOf("covered_twice_area"), 1.0 / layers, 1e-13) << layers;
  }
}

TEST(Overlap, OneTriangleOverManySmallOnes) {
  // The unit square in 800 triangles, and one large triangle over half of it and as much beside it.
  const Surface grid = Grid(20, 20);
  std::vector<Triangle> triangles;
  for (Index f = 0; f < grid.triangulation.num_faces(); ++f) {
    Triangle triangle;
    for (Index k = 0; k < 3; ++k) {
      triangle[k] = grid.position[grid.triangulation.vertex[3 * f + k]].head<2>() / 20;
    }
    triangles.push_back(triangle);
  }
  triangles.push_back({{{0, 0}, {1, 0}, {0, 2}}});
  const MapMeasures m = LooseTriangles(triangles, triangles).Measure();
  EXPECT_NEAR(m.ValueOf("overlap_area"), 0.75 / 2, 1e-12);
  EXPECT_NEAR(m.ValueOf("covered_twice_area"), 0.75 / 2, 1e-12);
}

TEST(Overlap, IsZeroExactlyWhereTrianglesOnlyTouch) {
  // Coordinates that are no binary fractions, sheared so that nothing is axis-aligned.
  const auto shear = [](const Eigen::Vector3d& p) {
    return Vector2d(p.x() / 3 + p.y() / 7, p.y() / 11 - p.x() / 13);
  };
  const MapMeasures m = MapOf(Grid(30, 30), shear).Measure();
  EXPECT_EQ(m.ValueOf("overlap_area"), 0);
  EXPECT_EQ(m.ValueOf("covered_twice_area"), 0);
}

/// Lengths of the parts of a horizontal line that are covered at least once and twice.
std::pair<double, double> CoveredLengths(const std::vector<Triangle>& triangles, double y) {
  std::vector<std::pair<double, int>> ends;
  for (const Triangle& t : triangles) {
    std::vector<double> x;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector2d &a = t[k], &b = t[(k + 1) % 3];
      if ((a.y() < y) != (b.y() < y)) {
        x.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
      }
    }
    if (x.size() != 2) continue;
    ends.emplace_back(std::min(x[0], x[1]), 1);
    ends.emplace_back(std::max(x[0], x[1]), -1);
  }
  std::sort(ends.begin(), ends.end());
  double once = 0, twice = 0;
  int depth = 0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    depth += ends[i].second;
    if (depth >= 1) once += ends[i + 1].first - ends[i].first;
    if (depth >= 2) twice += ends[i + 1].first - ends[i].first;
  }
  return {once, twice};
}

TEST(Overlap, RandomTrianglesAgreeWithScanlines) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(0, 1), size(0.02, 0.5);
  std::vector<Triangle> triangles(60);
  double total = 0;
  for (Triangle& t : triangles) {
    const Vector2d centre(coordinate(random), coordinate(random));
    const double s = size(random);
    for (Vector2d& p : t) p = centre + s * Vector2d(coordinate(random), coordinate(random));
    const Vector2d a = t[1] - t[0], b = t[2] - t[0];
    total += std::abs(a.x() * b.y() - a.y() * b.x()) / 2;
  }
  constexpr int kLines = 20000;
  double once = 0, twice = 0;
  for (int i = 0; i < kLines; ++i) {
    const auto [line_once, line_twice] = CoveredLengths(triangles, 1.5 * (i + 0.5) / kLines);
    once += 1.5 * line_once / kLines;
    twice += 1.5 * line_twice / kLines;
  }
  const MapMeasures m = LooseTriangles(triangles, triangles).Measure();
  EXPECT_GT(m.ValueOf("overlap_area"), m.ValueOf("covered_twice_area"));
  EXPECT_NEAR(m.ValueOf("overlap_area"), 1 - once / total, 1e-6);
  EXPECT_NEAR(m.ValueOf("covered_twice_area"), twice / total, 1e-6);
}

}  // namespace
}  // namespace cirque

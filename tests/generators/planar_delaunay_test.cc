#include "cirque/generators/planar_delaunay.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/generators/surface_chart.h"
#include "cirque/math/predicates.h"

namespace cirque {
namespace {

using Points = std::vector<Eigen::Vector2d>;

/// The number of points on the convex hull, those on its edges included: a monotone chain that
/// keeps collinear points.
Index HullPoints(Points points) {
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
  });
  Index count = 0;
  for (int half = 0; half < 2; ++half) {
    Points chain;
    for (const Eigen::Vector2d& p : points) {
      while (chain.size() >= 2 && OrientationSign(chain[chain.size() - 2], chain.back(), p) < 0) {
        chain.pop_back();
      }
      chain.push_back(p);
    }
    count += static_cast<Index>(chain.size()) - 1;
    std::reverse(points.begin(), points.end());
  }
  return count;
}

/// Every triangle counter-clockwise, edges paired, the empty circle across every interior edge
/// (which implies the global property), 2 n - h - 2 triangles: together, the Delaunay triangulation
/// of the whole hull.
void ExpectDelaunay(const Points& points, const std::vector<Triangle>& triangles, Index hull) {
  std::map<std::pair<Index, Index>, Index> opposite;
  for (const Triangle& t : triangles) {
    EXPECT_GT(OrientationSign(points[t[0]], points[t[1]], points[t[2]]), 0);
    for (int k = 0; k < 3; ++k) {
      EXPECT_TRUE(opposite.emplace(std::pair(t[k], t[(k + 1) % 3]), t[(k + 2) % 3]).second);
    }
  }
  Index violations = 0;
  Index boundary = 0;
  for (const auto& [edge, corner] : opposite) {
    const auto twin = opposite.find({edge.second, edge.first});
    if (twin == opposite.end()) {
      ++boundary;
      continue;
    }
    violations += InCircleSign(points[edge.first], points[edge.second], points[corner],
                               points[twin->second]) > 0;
  }
  EXPECT_EQ(violations, 0);
  EXPECT_EQ(boundary, hull);
  EXPECT_EQ(static_cast<Index>(triangles.size()), 2 * static_cast<Index>(points.size()) - hull - 2);
}

Points RandomPoints(Index count, unsigned seed) {
  UniformRandom random(seed);
  Points points(count);
  for (Eigen::Vector2d& p : points) {
    p.x() = random();
    p.y() = random();
  }
  return points;
}

TEST(PlanarDelaunay, RandomPoints) {
  for (const Index count : {3, 4, 5, 7, 10, 50, 400}) {
    for (unsigned seed = 0; seed < 5; ++seed) {
      const Points points = RandomPoints(count, seed);
      const auto triangles = PlanarDelaunay(points);
      ASSERT_TRUE(triangles.ok()) << triangles.status().message();
      ExpectDelaunay(points, *triangles, HullPoints(points));
    }
  }
}

TEST(PlanarDelaunay, EmptyCirclesAgainstAllPoints) {
  const Points points = RandomPoints(60, 3);
  const auto triangles = PlanarDelaunay(points);
  ASSERT_TRUE(triangles.ok());
  for (const Triangle& t : *triangles) {
    for (const Eigen::Vector2d& p : points) {
      EXPECT_LE(InCircleSign(points[t[0]], points[t[1]], points[t[2]], p), 0);
    }
  }
}

TEST(PlanarDelaunay, ClosedAtInfinityEveryEdgeHasTwoSides) {
  const Points points = RandomPoints(200, 8);
  const auto closed = ClosedPlanarDelaunay(points);
  const auto hull = PlanarDelaunay(points);
  ASSERT_TRUE(closed.ok() && hull.ok());
  std::set<std::pair<Index, Index>> edges;
  for (const Triangle& t : *closed) {
    for (int k = 0; k < 3; ++k) EXPECT_TRUE(edges.emplace(t[k], t[(k + 1) % 3]).second);
  }
  for (const auto& [tail, tip] : edges) EXPECT_TRUE(edges.contains({tip, tail}));
  EXPECT_EQ(static_cast<Index>(closed->size() - hull->size()), HullPoints(points));
}

TEST(PlanarDelaunay, TwentyThousandPoints) {
  const Points points = RandomPoints(20000, 9);
  const auto triangles = PlanarDelaunay(points);
  ASSERT_TRUE(triangles.ok());
  ExpectDelaunay(points, *triangles, HullPoints(points));
}

TEST(PlanarDelaunay, GridWhereEverySquareIsCocircular) {
  for (const double step : {1.0, 0.1}) {  // 0.1: not exactly cocircular any more
    Points points;
    for (int i = 0; i < 23; ++i) {
      for (int j = 0; j < 17; ++j) points.emplace_back(i * step, j);
    }
    const auto triangles = PlanarDelaunay(points);
    ASSERT_TRUE(triangles.ok());
    ExpectDelaunay(points, *triangles, 2 * (22 + 16));
  }
}

TEST(PlanarDelaunay, PointsOfOneCircleAndItsCentre) {
  Points points = {{0, 0}};
  // Twelve lattice points at distance exactly 5.
  for (const auto& [x, y] : {std::pair(5, 0), {3, 4}, {4, 3}}) {
    for (const int sign : {1, -1}) {
      points.emplace_back(sign * x, sign * y);
      points.emplace_back(-sign * y, sign * x);
    }
  }
  const auto triangles = PlanarDelaunay(points);
  ASSERT_TRUE(triangles.ok());
  ExpectDelaunay(points, *triangles, 12);
}

TEST(PlanarDelaunay, NearlyCollinearPoints) {
  // On the line y = x up to roundings of y by single ulps, and one point far off.
  Points points;
  for (int i = 0; i < 200; ++i) {
    const double x = 0.1 + i / 300.0;
    points.emplace_back(x, i % 3 == 0 ? std::nextafter(x, 2) : x);
  }
  points.emplace_back(1e6, -3);
  const auto triangles = PlanarDelaunay(points);
  ASSERT_TRUE(triangles.ok());
  ExpectDelaunay(points, *triangles, HullPoints(points));
}

TEST(PlanarDelaunay, CollinearPointsAndOneOffTheirLine) {
  Points points;
  for (int i = 0; i < 50; ++i) points.emplace_back(i * 7 % 50, 0);
  points.emplace_back(-20, 1);
  const auto triangles = PlanarDelaunay(points);
  ASSERT_TRUE(triangles.ok());
  ExpectDelaunay(points, *triangles, 51);
}

TEST(PlanarDelaunay, ScalesThatDifferByTwentyPowersOfTen) {
  Points points;
  UniformRandom random(4);
  for (int i = 0; i < 500; ++i) {
    const double radius = std::pow(10, random(0, 20)), angle = random(0, 2 * kPi);
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  const auto triangles = PlanarDelaunay(points);
  ASSERT_TRUE(triangles.ok());
  ExpectDelaunay(points, *triangles, HullPoints(points));
}

TEST(PlanarDelaunay, RefusesWhatHasNoTriangulation) {
  const auto message = [](const Points& points) {
    return PlanarDelaunay(points).status().message();
  };
  EXPECT_THAT(message({{0, 0}, {1, 0}}), testing::HasSubstr("at least 3"));
  EXPECT_THAT(message({{0, 0}, {1, 0}, {0, 1}, {1, 0}}), testing::HasSubstr("points 1 and 3"));
  EXPECT_THAT(message({{2, 2}, {2, 2}, {2, 2}}), testing::HasSubstr("coincide"));
  EXPECT_THAT(message({{0, 0}, {1, 1}, {3, 3}, {2, 2}}), testing::HasSubstr("one line"));
  EXPECT_THAT(message({{0, 0}, {1, std::nan("")}, {3, 3}}), testing::HasSubstr("point 1"));
}

TEST(HilbertOrder, VisitsASquareGridInUnitSteps) {
  Points points;
  for (int k = 0; k < 64 * 64; ++k) points.emplace_back(k * 29 % 64, k / 64);
  const std::vector<Index> order = HilbertOrder(points);
  EXPECT_EQ(std::set<Index>(order.begin(), order.end()).size(), points.size());
  for (std::size_t i = 1; i < order.size(); ++i) {
    EXPECT_EQ((points[order[i]] - points[order[i - 1]]).norm(), 1);
  }
}

}  // namespace
}  // namespace cirque

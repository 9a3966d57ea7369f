#include "cirque/mesh/ear_cutting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "cirque/core/types.h"
#include "cirque/math/predicates.h"
#include "cirque/mesh/preflight.h"

namespace cirque {
namespace {

using Points = std::vector<Eigen::Vector3d>;

Points InPlane(const std::vector<std::pair<double, double>>& points) {
  Points polygon;
  for (const auto& [x, y] : points) polygon.emplace_back(x, y, 0);
  return polygon;
}

Eigen::Vector3d Cross(const Points& point, const std::array<Index, 3>& t) {
  return (point[t[1]] - point[t[0]]).cross(point[t[2]] - point[t[0]]);
}

/// n - 2 triangles whose areas, all of one sign, add up to the polygon's: they neither fold nor
/// leave it.
void ExpectFilled(const Points& polygon) {
  const PolygonTriangles triangles = CutEars(polygon);
  ASSERT_EQ(triangles.size(), polygon.size() - 2);
  const Eigen::Vector3d normal = NewellNormal(polygon);
  double area = 0;
  std::set<Index> corners;
  for (const auto& t : triangles) {
    EXPECT_GT(Cross(polygon, t).dot(normal), 0);
    area += Cross(polygon, t).norm();
    corners.insert(t.begin(), t.end());
  }
  EXPECT_EQ(corners.size(), polygon.size());
  EXPECT_NEAR(area, normal.norm(), 1e-12 * normal.norm());
}

const Points kConcaveQuad = InPlane({{0, 0}, {1, 0}, {0.25, 0.25}, {0, 1}});
const Points kL = InPlane({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
const Points kSpiral = InPlane({{0, 0},
                                {6, 0},
                                {6, 6},
                                {1, 6},
                                {1, 2},
                                {4, 2},
                                {4, 4},
                                {3, 4},
                                {3, 3},
                                {2, 3},
                                {2, 5},
                                {5, 5},
                                {5, 1},
                                {0, 1}});
const Points kSquareOfTwelve = InPlane({{0, 0},
                                        {1, 0},
                                        {2, 0},
                                        {3, 0},
                                        {3, 1},
                                        {3, 2},
                                        {3, 3},
                                        {2, 3},
                                        {1, 3},
                                        {0, 3},
                                        {0, 2},
                                        {0, 1}});
const Points kTriangleWithPointsOnOneSide = InPlane({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1, 2}});

TEST(EarCutting, FillsPolygonsFromWhicheverCornerTheyBegin) {
  for (Points polygon :
       {kConcaveQuad, kL, kSpiral, kSquareOfTwelve, kTriangleWithPointsOnOneSide}) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      SCOPED_TRACE(polygon.size());
      ExpectFilled(polygon);
      std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
    }
  }
}

TEST(EarCutting, FillsStarsInAnyPlaneOfAnySize) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> radius(0.05, 1);
  for (int n = 4; n < 60; ++n) {
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
            .normalized();
    const double scale = std::exp(5 * normal(random));
    Points star;
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * kPi * i / n, r = scale * radius(random);
      star.push_back(turn * Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), 0));
    }
    SCOPED_TRACE(n);
    ExpectFilled(star);
  }
}

// A square with a square hole, round which it goes along a bridge from (0, 0) to (1, 1).
const Points kKeyhole =
    InPlane({{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}});

TEST(EarCutting, FillsAKeyholeAndLeavesItsHole) {
  Points polygon = kKeyhole;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    SCOPED_TRACE(i);
    ExpectFilled(polygon);  // of area 8, not 9
    std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
  }
}

TEST(EarCutting, FillsKeyholesWithTwoHolesAndWithABridgeBetweenHoles) {
  // Squares [1, 2]^2 and [3, 4] x [1, 2] in [0, 5] x [0, 3], the second bridged to the first.
  ExpectFilled(InPlane({{0, 0},
                        {5, 0},
                        {5, 3},
                        {0, 3},
                        {0, 0},
                        {1, 1},
                        {1, 2},
                        {2, 2},
                        {2, 1},
                        {3, 1},
                        {3, 2},
                        {4, 2},
                        {4, 1},
                        {3, 1},
                        {2, 1},
                        {1, 1}}));
}

TEST(EarCutting, TheTrianglesDoNotDependOnWhereThePolygonBegins) {
  for (Points polygon : {kL, kSpiral, kSquareOfTwelve, kKeyhole}) {
    const auto places = [&](std::size_t shift) {
      std::multiset<std::array<double, 6>> triangles;
      for (const auto& t : CutEars(polygon)) {
        std::array<std::pair<double, double>, 3> corners;
        for (int k = 0; k < 3; ++k) corners[k] = {polygon[t[k]].x(), polygon[t[k]].y()};
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()),
                    corners.end());
        triangles.insert({corners[0].first, corners[0].second, corners[1].first, corners[1].second,
                          corners[2].first, corners[2].second});
      }
      EXPECT_EQ(triangles.size(), polygon.size() - 2) << shift;
      return triangles;
    };
    const auto first = places(0);
    for (std::size_t i = 1; i < polygon.size(); ++i) {
      std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
      EXPECT_EQ(places(i), first) << i;
    }
  }
}

TEST(EarCutting, AConvexPolygonOfManyCornersIsCutFromAllSides) {
  Points circle;
  for (int i = 0; i < 1000; ++i) {
    circle.emplace_back(std::cos(2 * kPi * i / 1000), std::sin(2 * kPi * i / 1000), 0);
  }
  ExpectFilled(circle);
  std::vector<int> triangles(1000, 0);
  for (const auto& t : CutEars(circle)) {
    for (const Index v : t) ++triangles[v];
  }
  EXPECT_LE(*std::max_element(triangles.begin(), triangles.end()), 24);  // not a fan
}

TEST(EarCutting, ABentPolygonIsLookedAtAlongItsNormalWhereItCrossesItselfAlongTheAxis) {
  const Points polygon = {{-1, -1, 2}, {0, 2, -2}, {1, 2, -2}, {-1, -2, -1}, {-1, -2, 2}};
  Points along_axis = polygon;
  for (Eigen::Vector3d& p : along_axis) p.x() = 0;
  ASSERT_EQ(NewellNormal(polygon), Eigen::Vector3d(-16, 2, -5));
  ASSERT_TRUE(CutEars(along_axis).empty());
  const PolygonTriangles triangles = CutEars(polygon);
  EXPECT_EQ(triangles.size(), 3u);
  for (const auto& t : triangles) EXPECT_GT(Cross(polygon, t).dot(NewellNormal(polygon)), 0);
}

TEST(EarCutting, APolygonMayBeSoThinThatSquaresOfItsAreaAreZero) {
  for (const double thin : {1e-150, 1e-200, 1e-300, 5e-324}) {
    const std::vector<std::pair<double, double>> outline = {
        {0, 0}, {1, 0}, {1, thin}, {0.5, thin}, {0, thin}};
    const PolygonTriangles triangles = CutEars(InPlane(outline));
    EXPECT_EQ(triangles.size(), 3u);
    const auto at = [&](Index v) { return Eigen::Vector2d(outline[v].first, outline[v].second); };
    for (const auto& t : triangles) EXPECT_EQ(OrientationSign(at(t[0]), at(t[1]), at(t[2])), 1);
    // One that crosses itself is looked at along its normal too.
    EXPECT_TRUE(CutEars(InPlane({{0, 0}, {1, thin}, {1, 0}, {0.5, 0}, {0, thin}})).empty());
  }
}

TEST(EarCutting, WhatIsNoSimplePolygonHasNoTriangles) {
  EXPECT_TRUE(CutEars(InPlane({{0, 0}, {1, 1}, {1, 0}, {0, 1}})).empty());  // a bow tie
  EXPECT_TRUE(CutEars(InPlane({{0, 0}, {1, 0}, {2, 0}, {3, 0}})).empty());  // no area
  EXPECT_TRUE(CutEars(InPlane({{0, 0}, {1, 0}})).empty());
}

double AreaOf(const Points& polygon) {
  PolygonSoup soup;
  soup.position = polygon;
  for (Index v = 0; v < static_cast<Index>(polygon.size()); ++v) soup.corner.push_back(v);
  soup.first_corner.push_back(static_cast<Index>(polygon.size()));
  PreflightReport report;
  const StatusOr<Surface> surface = Preflight(soup, &report);
  EXPECT_TRUE(surface.ok()) << surface.status().message();
  double area = 0;
  for (Index f = 0; f < surface->triangulation.num_faces(); ++f) {
    const Index* const v = &surface->triangulation.vertex[3 * f];
    area += 0.5 * Cross(surface->position, {v[0], v[1], v[2]}).norm();
  }
  return area;
}

TEST(Preflight, ConcavePolygonsAreSplitInsideThemselves) {
  EXPECT_DOUBLE_EQ(AreaOf(kConcaveQuad), 0.25);
  EXPECT_DOUBLE_EQ(AreaOf(kL), 3);
  EXPECT_DOUBLE_EQ(AreaOf(kSquareOfTwelve), 9);
}

}  // namespace
}  // namespace cirque

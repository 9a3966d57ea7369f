#include "cirque/mesh/ear_cutting.h"

#include <cmath>
#include <random>
#include <set>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "cirque/core/types.h"
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

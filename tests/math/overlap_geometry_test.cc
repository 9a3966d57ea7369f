#include "cirque/math/overlap_geometry.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace cirque {
namespace {

using Eigen::Vector2d;

constexpr PlaneTriangle::size_type kSides = 3;

TEST(InteriorsMeet, NotWhereTrianglesOnlyTouch) {
  const PlaneTriangle triangle = {{{0, 0}, {1, 0}, {0, 1}}};
  const PlaneTriangle across = {{{1, 0}, {1, 1}, {0, 1}}};            // shares a side
  const PlaneTriangle at_corner = {{{1, 0}, {2, 0}, {2, 1}}};         // shares a corner
  const PlaneTriangle along = {{{0.2, 0}, {0.2, -1}, {0.7, -0.01}}};  // a corner on a side
  for (const PlaneTriangle& other : {across, at_corner, along}) {
    EXPECT_FALSE(InteriorsMeet(triangle, other));
    EXPECT_FALSE(InteriorsMeet(other, triangle));
  }
}

TEST(InteriorsMeet, BySingleUlps) {
  const PlaneTriangle triangle = {{{0, 0}, {1, 0}, {0, 1}}};
  const double above = std::nextafter(0.0, 1.0), below = -above;
  EXPECT_TRUE(InteriorsMeet(triangle, {{{0.2, above}, {0.2, -1}, {0.7, -1}}}));
  EXPECT_FALSE(InteriorsMeet(triangle, {{{0.2, below}, {0.2, -1}, {0.7, -1}}}));
  // One within the other, and crossing without a corner inside.
  EXPECT_TRUE(InteriorsMeet(triangle, {{{0.1, 0.1}, {0.2, 0.1}, {0.1, 0.2}}}));
  EXPECT_TRUE(InteriorsMeet(triangle, {{{-1, 0.1}, {2, 0.1}, {2, 0.2}}}));
  EXPECT_TRUE(InteriorsMeet(triangle, triangle));
}

PlaneTriangle RandomTriangle(std::mt19937* random) {
  std::uniform_real_distribution<double> coordinate(-1, 1);
  PlaneTriangle t;
  for (Vector2d& p : t) p = Vector2d(coordinate(*random), coordinate(*random));
  const Vector2d a = t[1] - t[0], b = t[2] - t[0];
  if (a.x() * b.y() < a.y() * b.x()) std::swap(t[1], t[2]);
  return t;
}

bool IsInside(const PlaneTriangle& t, const Vector2d& p) {
  for (std::size_t k = 0; k < kSides; ++k) {
    const Vector2d side = t[(k + 1) % kSides] - t[k], to = p - t[k];
    if (side.x() * to.y() - side.y() * to.x() < -1e-12) return false;
  }
  return true;
}

TEST(CutByTriangle, PiecesAreConvexApartAndOfTheWholeArea) {
  std::mt19937 random(8);
  int cut = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const PlaneTriangle subject = RandomTriangle(&random), knife = RandomTriangle(&random);
    const ConvexPolygon whole(subject.begin(), subject.end());
    std::vector<ConvexPolygon> outside;
    const ConvexPolygon inside = CutByTriangle(whole, knife, &outside);
    EXPECT_LE(outside.size(), kSides);
    double area = Area(inside);
    for (const ConvexPolygon& piece : outside) {
      EXPECT_GE(Area(piece), -1e-15);
      area += Area(piece);
    }
    EXPECT_NEAR(area, Area(whole), 1e-14);
    for (const Vector2d& p : inside) EXPECT_TRUE(IsInside(knife, p) && IsInside(subject, p));
    EXPECT_EQ(Area(inside) > 1e-12, InteriorsMeet(subject, knife)) << trial;
    cut += inside.empty() ? 0 : 1;
  }
  EXPECT_GT(cut, 50);
  EXPECT_LT(cut, 200);
}

TEST(CutByTriangle, OfKnownPieces) {
  // The unit square and the triangle over its upper left half and beyond.
  const ConvexPolygon square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  std::vector<ConvexPolygon> outside;
  const ConvexPolygon inside = CutByTriangle(square, {{{0, 0}, {2, 2}, {0, 2}}}, &outside);
  EXPECT_EQ(Area(inside), 0.5);
  ASSERT_EQ(outside.size(), 1u);
  EXPECT_EQ(Area(outside[0]), 0.5);
  outside.clear();
  EXPECT_TRUE(CutByTriangle(square, {{{5, 5}, {6, 5}, {5, 6}}}, &outside).empty());
}

}  // namespace
}  // namespace cirque

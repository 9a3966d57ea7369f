#include "cirque/metrics/injectivity.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

CornerUv UvOf(const Surface& s) {
  CornerUv uv;
  for (const Index v : s.triangulation.vertex) uv.value.push_back(s.position[v].head<2>());
  return uv;
}

void MoveVertex(const Surface& s, Index v, const Eigen::Vector2d& to, CornerUv* uv) {
  for (Index h = 0; h < s.triangulation.num_halfedges(); ++h) {
    if (s.triangulation.vertex[h] == v) uv->value[h] = to;
  }
}

TEST(Injectivity, FlatFanIsInjective) {
  const Surface fan = Fan(7, 0);
  EXPECT_TRUE(FlippedFaces(fan.triangulation, UvOf(fan)).empty());
  EXPECT_FALSE(OverlapsItself(fan.triangulation, UvOf(fan)));
}

TEST(Injectivity, CollapsedAndReflectedFacesAreFlipped) {
  const Surface fan = Fan(6, 0);
  CornerUv uv = UvOf(fan);
  MoveVertex(fan, 0, fan.position[1].head<2>(),
             &uv);  // the centre onto the rim: two faces collapse
  EXPECT_EQ(FlippedFaces(fan.triangulation, uv), (std::vector<Index>{0, 5}));
  for (Eigen::Vector2d& p : uv.value) p.x() = -p.x();
  EXPECT_EQ(FlippedFaces(fan.triangulation, uv).size(), 6u);
}

/// A strip wound round the origin by so many turns, each as far out as the one before.
CornerUv Wound(const Surface& strip, int columns, double turns, double rise) {
  CornerUv uv;
  for (const Index v : strip.triangulation.vertex) {
    const double angle = 2 * kPi * turns * (1 - strip.position[v].x() / columns);
    const double radius = 2 + strip.position[v].y() + rise * angle;
    uv.value.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return uv;
}

// Coordinates that 32 bits cannot hold collapse no fewer faces than zeros do.
TEST(Injectivity, FacesWhoseCoordinatesOverflowAreFlipped) {
  const Surface fan = Fan(6, 0);
  CornerUv uv = UvOf(fan);
  for (Eigen::Vector2d& x : uv.value) x *= 1e60;
  EXPECT_TRUE(FlippedFaces(fan.triangulation, uv).empty());
  EXPECT_EQ(FlippedFacesInFloat32(fan.triangulation, uv).size(), 6u);
  uv.value[3].x() = std::numeric_limits<double>::infinity();
  uv.value[7].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(FlippedFaces(fan.triangulation, uv), (std::vector<Index>{1, 2}));
}

// Seven triangles that turn twice round their middle: none is flipped.
TEST(Injectivity, ImagesThatWindRoundAVertexAreFound) {
  const Surface fan = Fan(7, 0);
  CornerUv uv = UvOf(fan);
  EXPECT_TRUE(WoundVertices(fan.triangulation, uv).empty());
  for (int k = 0; k < 7; ++k) {
    const double angle = 0.1 + 4 * kPi * k / 7;
    MoveVertex(fan, k + 1, {std::cos(angle), std::sin(angle)}, &uv);
  }
  EXPECT_TRUE(FlippedFaces(fan.triangulation, uv).empty());
  EXPECT_EQ(WoundVertices(fan.triangulation, uv), (std::vector<Index>{0}));
}

TEST(OverlapsItself, WhatLiesUponItselfDoesAndWhatTouchesDoesNot) {
  const Surface strip = FlatStrip(40, 1);
  const Triangulation& t = strip.triangulation;
  EXPECT_FALSE(OverlapsItself(t, Wound(strip, 40, 0.9, 0)));
  EXPECT_TRUE(OverlapsItself(t, Wound(strip, 40, 1.1, 0)));
  EXPECT_TRUE(OverlapsItself(t, Wound(strip, 40, 2, 0)));     // no two edges cross
  EXPECT_FALSE(OverlapsItself(t, Wound(strip, 40, 2, 0.3)));  // a spiral
  // The ends of a strip bent to a square frame touch along an edge, at both of its vertices.
  const Surface frame = FlatStrip(4, 1);
  const Eigen::Vector2d inner[5] = {{1, 1}, {1, -1}, {-1, -1}, {-1, 1}, {1, 1}};
  CornerUv uv;
  for (const Index v : frame.triangulation.vertex) {
    const auto i = static_cast<int>(frame.position[v].x());
    uv.value.push_back((1 + frame.position[v].y()) * inner[i]);
  }
  ASSERT_TRUE(FlippedFaces(frame.triangulation, uv).empty());
  EXPECT_FALSE(OverlapsItself(frame.triangulation, uv));
}

// Nine triangles round a vertex of the boundary, by more than a turn.
TEST(OverlapsItself, SeesABoundaryVertexThatIsGoneRoundMoreThanOnce) {
  const Surface fan = Fan(9, 0);
  const Triangulation& t = fan.triangulation;
  const Index opened = t.edge[t.twin[0] == kNone ? 1 : 0];
  Cut cut{std::vector<bool>(t.num_edges(), false)};
  cut.edge[opened] = true;
  const Triangulation open = CutOpen(t, cut);
  CornerUv uv;
  for (Index h = 0; h < t.num_halfedges(); ++h) uv.value.push_back({0, 0});
  Index h = kNone;  // the halfedge from the centre of the face that the others follow
  const Index centre = 0;
  for (Index g = 0; g < t.num_halfedges(); ++g) {
    if (open.twin[g] == kNone && t.Tail(g) == centre) h = g;
  }
  ASSERT_NE(h, kNone);
  for (int k = 0; k < 9; ++k) {
    const auto at = [](int i) -> Eigen::Vector2d {
      return Eigen::Vector2d(std::cos(0.75 * i), std::sin(0.75 * i)) * (1 + 0.1 * i);
    };
    uv.value[Triangulation::Prev(h)] = at(k);
    uv.value[h] = at(k + 1);
    h = open.twin[Triangulation::Prev(h)];
  }
  ASSERT_TRUE(FlippedFaces(t, uv).empty());
  EXPECT_TRUE(OverlapsItself(open, uv));
}

}  // namespace
}  // namespace cirque

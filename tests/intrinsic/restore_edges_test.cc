// Flat patches flipped away from their edges: all come back, by flips that keep the plane.
#include "cirque/intrinsic/restore_edges.h"

#include <random>

#include <gtest/gtest.h>

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

struct Scrambled {
  explicit Scrambled(const Surface& surface)
      : input(surface.triangulation), normal(input), metric(input, MeasureEdgeLengths(surface)) {
    std::mt19937 random(5);
    for (int i = 0; i < 400; ++i) {
      const Index h = static_cast<Index>(random() % input.vertex.size()), g = metric.twin(h);
      if (g == kNone || h / 3 == g / 3) continue;
      const auto length = metric.OtherDiagonal(h);
      if (!length || metric.RatioAfterFlip(h, *length) > 1e4) continue;
      metric.Flip(h, *length, kNone);
      normal.Flip(h);
    }
  }

  int Shared() const {
    int count = 0;
    for (Index h = 0; h < input.num_halfedges(); ++h) count += normal.IsShared(h) ? 1 : 0;
    return count;
  }

  const Triangulation input;
  NormalCoordinates normal;
  FlipComplex metric;
};

TEST(RestoreEdges, AllEdgesOfAFlatPatchComeBack) {
  const Surface patch = GeneratedSurface("flat_delaunay_patch", 120);
  Scrambled scrambled(patch);
  const Triangulation& t = scrambled.input;
  ASSERT_LT(scrambled.Shared(), t.num_halfedges() * 3 / 4);
  std::vector<Index> flips;
  ASSERT_TRUE(RestoreEdges(t, std::vector<bool>(t.num_edges(), true), &scrambled.normal,
                           &scrambled.metric, &flips));
  EXPECT_GT(flips.size(), 20u);
  EXPECT_EQ(scrambled.Shared(), t.num_halfedges());
  const Triangulation back = scrambled.metric.MakeTriangulation(t.num_vertices);
  const EdgeLengths lengths = scrambled.metric.MakeLengths(back);
  for (Index e = 0; e < back.num_edges(); ++e) {
    const Index h = back.edge_halfedge[e];
    const double length = (patch.position[back.Tail(h)] - patch.position[back.Tip(h)]).norm();
    EXPECT_NEAR(lengths.value[e], length, 1e-10);
  }
}

TEST(RestoreEdges, ThoseThatAreAskedForAndNoOthersNeed) {
  const Surface patch = GeneratedSurface("flat_delaunay_patch", 120);
  const Triangulation& t = patch.triangulation;
  Scrambled scrambled(patch);
  std::vector<bool> wanted(t.num_edges(), false);
  std::vector<bool> shared(t.num_edges(), false);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (scrambled.normal.IsShared(h)) shared[t.edge[scrambled.normal.SharedHalfedge(h)]] = true;
  }
  Index one = 0;
  while (shared[one]) ++one;
  wanted[one] = true;
  std::vector<Index> flips;
  ASSERT_TRUE(RestoreEdges(t, wanted, &scrambled.normal, &scrambled.metric, &flips));
  ASSERT_FALSE(flips.empty());
  bool is_there = false;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    is_there = is_there ||
               (scrambled.normal.IsShared(h) && t.edge[scrambled.normal.SharedHalfedge(h)] == one);
  }
  EXPECT_TRUE(is_there);
  flips.clear();
  ASSERT_TRUE(RestoreEdges(t, wanted, &scrambled.normal, &scrambled.metric, &flips));
  EXPECT_TRUE(flips.empty());
}

TEST(RestoreEdges, WhatIsNotStraightDoesNotComeBack) {
  // The diagonal of a square is flipped, and the square dented at one end of the other: it would run
  // outside.
  const Surface square = FlatStrip(1, 1);
  const Triangulation& t = square.triangulation;
  Index diagonal = 0;
  while (t.IsBoundaryEdge(diagonal)) ++diagonal;
  const Index h = t.edge_halfedge[diagonal], end = t.vertex[h];
  NormalCoordinates normal(t);
  FlipComplex flipped(t, MeasureEdgeLengths(square));
  flipped.Flip(h, *flipped.OtherDiagonal(h), kNone);
  normal.Flip(h);
  const Triangulation other = flipped.MakeTriangulation(t.num_vertices);
  EdgeLengths dented = flipped.MakeLengths(other);
  for (Index e = 0; e < other.num_edges(); ++e) {
    const Index g = other.edge_halfedge[e];
    const bool at_end = other.Tail(g) == end || other.Tip(g) == end;
    if (other.IsBoundaryEdge(e)) dented.value[e] = at_end ? 0.5 : 1.7;
  }
  FlipComplex metric(other, dented);
  std::vector<Index> flips;
  std::vector<bool> wanted(t.num_edges(), false);
  wanted[diagonal] = true;
  EXPECT_FALSE(RestoreEdges(t, wanted, &normal, &metric, &flips));
  EXPECT_TRUE(flips.empty());
}

}  // namespace
}  // namespace cirque

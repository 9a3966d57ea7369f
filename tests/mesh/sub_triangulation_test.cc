#include <algorithm>

#include <gtest/gtest.h>

#include "cirque/mesh/holes.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

TEST(SubTriangulation, KeepsFacesLengthsAndGluing) {
  const Surface surface = GeneratedSurface("hemisphere", 200);
  const Triangulation& whole = surface.triangulation;
  std::vector<bool> keep(whole.num_faces(), true);
  const Index apex = whole.vertex[0];  // its star is taken off
  for (Index h = 0; h < whole.num_halfedges(); ++h) {
    if (whole.vertex[h] == apex) keep[h / 3] = false;
  }
  const SubTriangulation part = KeepFaces(whole, keep);
  const Triangulation& t = part.triangulation;
  EXPECT_EQ(t.num_faces(), std::count(keep.begin(), keep.end(), true));
  EXPECT_EQ(part.of_vertex[apex], kNone);
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const EdgeLengths own = LengthsOf(part, whole, lengths);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const Index g = part.Halfedge(h);
    EXPECT_EQ(part.vertex[t.vertex[h]], whole.vertex[g]);
    EXPECT_EQ(own.value[t.edge[h]], lengths.value[whole.edge[g]]);
    if (t.twin[h] != kNone) {
      EXPECT_EQ(part.Halfedge(t.twin[h]), whole.twin[g]);
    }
    if (t.twin[h] == kNone && whole.twin[g] != kNone) {
      EXPECT_FALSE(keep[whole.twin[g] / 3]);
    }
  }
}

TEST(SubTriangulation, ChordsCutOffTheSmallerPieces) {
  // Two hexagonal fans would share an edge; a strip of one row is all chords.
  const Surface strip = FlatStrip(4, 1);
  const std::vector<bool> piece =
      LargestChordlessPiece(strip.triangulation, BoundaryVertices(strip.triangulation));
  EXPECT_EQ(std::count(piece.begin(), piece.end(), true), 1);
  const Surface block = FlatStrip(4, 4);
  const std::vector<bool> all =
      LargestChordlessPiece(block.triangulation, BoundaryVertices(block.triangulation));
  EXPECT_EQ(std::count(all.begin(), all.end(), true), block.triangulation.num_faces());
}

}  // namespace
}  // namespace cirque

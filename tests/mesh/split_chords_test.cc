#include "cirque/mesh/split_chords.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "cirque/intrinsic/intrinsic_surface.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

double AreaOf(const Surface& surface) {
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  return SurfaceArea(MeasureSurface(surface.triangulation, lengths));
}

/// What Triangulation promises.
void ExpectConsistent(const Triangulation& t) {
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (t.twin[h] == kNone) continue;
    ASSERT_EQ(t.twin[t.twin[h]], h);
    EXPECT_EQ(t.Tail(h), t.Tip(t.twin[h]));
    EXPECT_EQ(t.edge[h], t.edge[t.twin[h]]);
  }
}

TEST(SplitEdges, KeepTheSurfaceWhateverIsSplit) {
  for (const char* name : {"bumpy_terrain", "annulus", "torus"}) {
    const Surface surface = GeneratedSurface(name, 500);
    const Triangulation& t = surface.triangulation;
    for (const int every : {1, 2, 3, 7}) {
      std::vector<bool> edges(t.num_edges(), false);
      Index more = 0, middles = 0;
      for (Index e = 0; e < t.num_edges(); e += every) {
        edges[e] = true;
        ++middles;
        more += t.IsBoundaryEdge(e) ? 1 : 2;
      }
      const Surface split = SplitEdges(surface, edges);
      const Triangulation& s = split.triangulation;
      ExpectConsistent(s);
      EXPECT_EQ(s.num_vertices, t.num_vertices + middles);
      EXPECT_EQ(s.num_faces(), t.num_faces() + more);
      EXPECT_EQ(EulerCharacteristic(s), EulerCharacteristic(t));
      EXPECT_EQ(BoundaryLoops(s).size(), BoundaryLoops(t).size());
      EXPECT_NEAR(AreaOf(split) / AreaOf(surface), 1, 1e-12);
      for (Index v = 0; v < t.num_vertices; ++v) EXPECT_EQ(split.position[v], surface.position[v]);
    }
  }
}

TEST(ChordsOf, AreGoneOnceTheyAreSplit) {
  // One row of squares: all inner edges are chords.
  const Surface row = FlatStrip(6, 1);
  const std::vector<std::vector<Index>> loops = BoundaryLoops(row.triangulation);
  const std::vector<bool> chords = ChordsOf(row.triangulation, loops[0]);
  EXPECT_EQ(std::count(chords.begin(), chords.end(), true), 11);
  const Surface split = SplitEdges(row, chords);
  const std::vector<bool> left =
      ChordsOf(split.triangulation, BoundaryLoops(split.triangulation)[0]);
  EXPECT_EQ(std::count(left.begin(), left.end(), true), 0);
}

TEST(ChordsOf, OfAWellMadeRingAreNone) {
  const Surface ring = GeneratedSurface("annulus", 2000);
  for (const std::vector<Index>& loop : BoundaryLoops(ring.triangulation)) {
    const std::vector<bool> chords = ChordsOf(ring.triangulation, loop);
    EXPECT_EQ(std::count(chords.begin(), chords.end(), true), 0);
  }
}

}  // namespace
}  // namespace cirque

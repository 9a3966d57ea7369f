// Triangulation::ForEachCornerAround.
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/core/triangulation.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

std::vector<Index> CornersAround(const Triangulation& t, Index corner) {
  std::vector<Index> corners;
  t.ForEachCornerAround(corner, [&](Index c) { corners.push_back(c); });
  return corners;
}

std::vector<std::vector<Index>> CornersOfVertices(const Triangulation& t) {
  std::vector<std::vector<Index>> corners(t.num_vertices);
  for (Index h = 0; h < t.num_halfedges(); ++h) corners[t.vertex[h]].push_back(h);
  return corners;
}

/// Whether the face at corner `next` follows the one at `corner` counter-clockwise: the halfedge by
/// which the first is left ends at the vertex, that by which the next is entered begins there.
bool Follows(const Triangulation& t, Index corner, Index next) {
  return t.twin[Triangulation::Next(corner)] == Triangulation::Prev(next);
}

void ExpectWalks(const Triangulation& t) {
  const std::vector<std::vector<Index>> all = CornersOfVertices(t);
  const std::vector<bool> boundary = BoundaryVertices(t);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    SCOPED_TRACE(h);
    const std::vector<Index> walk = CornersAround(t, h);
    ASSERT_EQ(walk.front(), h);
    ASSERT_THAT(walk, testing::UnorderedElementsAreArray(all[t.vertex[h]]));
    if (boundary[t.vertex[h]]) continue;
    for (std::size_t i = 0; i < walk.size(); ++i) {
      EXPECT_TRUE(Follows(t, walk[i], walk[(i + 1) % walk.size()]));
    }
  }
}

TEST(CornerWalk, VisitsEveryCornerOfTheVertexOnce) {
  for (const char* name : {"bumpy_terrain", "annulus", "torus", "double_torus", "sphere"}) {
    SCOPED_TRACE(name);
    ExpectWalks(GeneratedSurface(name, 400).triangulation);
  }
  ExpectWalks(RegularPolyhedron(4).triangulation);
  ExpectWalks(Fan(7, 0.3).triangulation);
}

TEST(CornerWalk, PassesThroughFacesGluedToThemselves) {
  // Halfedge 0 of the torus and one inside the disk.
  const Triangulation torus = GeneratedSurface("torus", 400).triangulation;
  ExpectWalks(WithFoldedFace(torus, 0));
  const Triangulation disk = FlatStrip(2, 2).triangulation;
  Index inner = 0;
  while (disk.twin[inner] == kNone) ++inner;
  const Triangulation folded = WithFoldedFace(disk, inner);
  ExpectWalks(folded);
  EXPECT_THAT(CornersAround(folded, folded.num_halfedges() - 3),
              testing::ElementsAre(folded.num_halfedges() - 3));
  // Two triangles on one vertex, the opposite sides of their square glued: a torus.
  ExpectWalks(NumberEdges(1, {0, 0, 0, 0, 0, 0}, {3, 4, 5, 0, 1, 2}));
}

/// In the plane: the sine of the angle from the middle of corner a's opposite edge to that of b's,
/// as seen from their vertex, but for a positive factor.
double Turn(const Surface& surface, Index a, Index b) {
  const Triangulation& t = surface.triangulation;
  const auto direction = [&](Index c) {
    return ((surface.position[t.Tail(c)] + surface.position[t.Tip(c)]) / 2 -
            surface.position[t.vertex[c]])
        .eval();
  };
  const Eigen::Vector3d from = direction(a), to = direction(b);
  return from.x() * to.y() - from.y() * to.x();
}

TEST(CornerWalk, TurnsCounterClockwiseAndOnTheBoundaryThenBack) {
  const Surface square = GeneratedSurface("flat_delaunay_patch", 400);
  const Triangulation& t = square.triangulation;
  const std::vector<bool> boundary = BoundaryVertices(t);
  int num_back = 0;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const std::vector<Index> walk = CornersAround(t, h);
    bool back = false;
    for (std::size_t i = 1; i < walk.size(); ++i) {
      // On the boundary of a convex shape all corners lie within half a turn.
      const bool turns_back = !back && boundary[t.vertex[h]] && Turn(square, h, walk[i]) < 0;
      if (turns_back) ++num_back;
      back = back || turns_back;
      const double turn = Turn(square, turns_back ? h : walk[i - 1], walk[i]);
      EXPECT_GT(back ? -turn : turn, 0) << h;
    }
  }
  EXPECT_GT(num_back, 20);
}

}  // namespace
}  // namespace cirque

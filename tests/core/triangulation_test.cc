// The invariants of a triangulation, its corner walks, boundary loops and cuts.
#include "cirque/core/triangulation.h"

#include <algorithm>
#include <set>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/renumbering.h"
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

constexpr const char* kGenerators[] = {"bumpy_terrain", "annulus", "torus", "double_torus",
                                       "sphere"};

void ExpectInvariants(const Triangulation& t) {
  std::vector<bool> used(t.num_vertices, false);
  Index next_edge = 0;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    used[t.vertex[h]] = true;
    const Index g = t.twin[h];
    const bool first = g == kNone || g > h;
    EXPECT_EQ(t.edge[h], first ? next_edge++ : t.edge[g]);
    EXPECT_EQ(t.edge_halfedge[t.edge[h]], first ? h : g);
    EXPECT_EQ(t.IsBoundaryEdge(t.edge[h]), g == kNone);
    EXPECT_EQ(Triangulation::Prev(Triangulation::Next(h)), h);
    EXPECT_EQ(t.vertex[h], t.Tail(Triangulation::Prev(h)));
    if (g == kNone) continue;
    EXPECT_EQ(t.twin[g], h);
    EXPECT_EQ(t.Tail(g), t.Tip(h));
    EXPECT_EQ(t.Tip(g), t.Tail(h));
  }
  EXPECT_EQ(next_edge, t.num_edges());
  EXPECT_EQ(std::count(used.begin(), used.end(), false), 0);
}

TEST(Triangulation, InvariantsHoldHoweverItIsNumbered) {
  for (const char* name : kGenerators) {
    SCOPED_TRACE(name);
    const Triangulation t = GeneratedSurface(name, 300).triangulation;
    ExpectInvariants(t);
    const Renumbering r = Renumber(t, 9);
    ExpectInvariants(r.triangulation);
    EXPECT_EQ(EulerCharacteristic(r.triangulation), EulerCharacteristic(t));
    EXPECT_EQ(BoundaryLoops(r.triangulation).size(), BoundaryLoops(t).size());
    const std::vector<Index> corners = CornersPerVertex(t);
    const std::vector<Index> corners_there = CornersPerVertex(r.triangulation);
    const std::vector<bool> boundary = BoundaryVertices(t);
    const std::vector<bool> boundary_there = BoundaryVertices(r.triangulation);
    for (Index v = 0; v < t.num_vertices; ++v) {
      EXPECT_EQ(corners_there[r.vertex[v]], corners[v]);
      EXPECT_EQ(boundary_there[r.vertex[v]], boundary[v]);
    }
  }
  ExpectInvariants(WithFoldedFace(RegularPolyhedron(8).triangulation, 5));
}

TEST(Triangulation, EulerCharacteristicAndLoopsOfKnownSurfaces) {
  const std::tuple<const char*, int, std::size_t> kTable[] = {{"sphere", 2, 0},
                                                              {"bumpy_terrain", 1, 1},
                                                              {"annulus", 0, 2},
                                                              {"torus", 0, 0},
                                                              {"double_torus", -2, 0}};
  for (const auto& [name, chi, loops] : kTable) {
    const Triangulation t = GeneratedSurface(name, 400).triangulation;
    EXPECT_EQ(EulerCharacteristic(t), chi) << name;
    EXPECT_EQ(BoundaryLoops(t).size(), loops) << name;
  }
}

TEST(Triangulation, BoundaryLoopsChainEveryBoundaryHalfedgeOnce) {
  const Triangulation t = GeneratedSurface("annulus", 400).triangulation;
  std::set<Index> seen;
  Index last_start = kNone;
  for (const std::vector<Index>& loop : BoundaryLoops(t)) {
    EXPECT_EQ(loop.front(), *std::min_element(loop.begin(), loop.end()));
    EXPECT_GT(loop.front(), last_start);
    last_start = loop.front();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      EXPECT_EQ(t.twin[loop[i]], kNone);
      EXPECT_TRUE(seen.insert(loop[i]).second);
      EXPECT_EQ(t.Tip(loop[i]), t.Tail(loop[(i + 1) % loop.size()]));
    }
  }
  EXPECT_EQ(static_cast<Index>(seen.size()), std::count(t.twin.begin(), t.twin.end(), kNone));
}

TEST(CutOpen, ATetrahedronFallsIntoItsFacesOrUnfolds) {
  const Triangulation t = RegularPolyhedron(4).triangulation;
  Cut all{std::vector<bool>(6, true)};
  const Triangulation apart = CutOpen(t, all);
  ExpectInvariants(apart);
  EXPECT_EQ(apart.num_vertices, 12);
  EXPECT_EQ(ConnectedPatches(apart).count, 4);
  // The three edges at one vertex: a disk of three triangles round a fourth.
  Cut star{std::vector<bool>(6, false)};
  for (Index e = 0; e < 6; ++e) {
    const Index h = t.edge_halfedge[e];
    star.edge[e] = t.Tail(h) == 2 || t.Tip(h) == 2;
  }
  const Triangulation net = CutOpen(t, star);
  ExpectInvariants(net);
  EXPECT_EQ(EulerCharacteristic(net), 1);
  EXPECT_EQ(net.num_vertices, 6);
  EXPECT_EQ(BoundaryLoops(net).size(), 1u);
  EXPECT_EQ(ConnectedPatches(net).count, 1);
}

TEST(CutOpen, KeepsNumbersWhereItCan) {
  const Triangulation t = GeneratedSurface("torus", 200).triangulation;
  Cut cut{std::vector<bool>(t.num_edges(), false)};
  EXPECT_TRUE(cut.IsEmpty());
  EXPECT_EQ(CutOpen(t, cut).twin, t.twin);
  // One edge opens to a slit, its ends stay one vertex each.
  cut.edge[17] = true;
  EXPECT_FALSE(cut.IsEmpty());
  const Triangulation slit = CutOpen(t, cut);
  ExpectInvariants(slit);
  EXPECT_EQ(slit.vertex, t.vertex);
  EXPECT_EQ(slit.num_edges(), t.num_edges() + 1);
  ASSERT_EQ(BoundaryLoops(slit).size(), 1u);
  EXPECT_EQ(BoundaryLoops(slit)[0].size(), 2u);
}

}  // namespace
}  // namespace cirque

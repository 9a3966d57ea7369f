#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "cirque/intrinsic/input_chart.h"
#include "cirque/math/predicates.h"

#include "tests/common/surfaces.h"
#include "tests/mesh/scrambled.h"

namespace cirque {
namespace {

using testing::IntrinsicMesh;

void ExpectRestored(const IntrinsicMesh& input, const FlippedBack& back, double tolerance) {
  EXPECT_TRUE(back.stuck.empty());
  EXPECT_EQ(back.triangulation.vertex, input.triangulation.vertex);
  EXPECT_EQ(back.triangulation.twin, input.triangulation.twin);
  EXPECT_EQ(back.triangulation.edge, input.triangulation.edge);
  ASSERT_EQ(back.lengths.value.size(), input.lengths.value.size());
  for (Index e = 0; e < back.lengths.value.size(); ++e) {
    EXPECT_NEAR(back.lengths.value[e] / input.lengths.value[e], 1, tolerance);
  }
}

TEST(FlipBack, RestoresAFlatMeshExactly) {
  const Surface patch = GeneratedSurface("flat_delaunay_patch", 2000);
  const IntrinsicMesh input =
      testing::Scramble({patch.triangulation, MeasureEdgeLengths(patch)}, 1000, 1);
  const IntrinsicTriangulation delaunay = MakeIntrinsicDelaunay(input.triangulation, input.lengths);
  ASSERT_GT(delaunay.flips.size(), 100);
  ExpectRestored(input, FlipBack(delaunay, delaunay.lengths), 1e-12);
}

TEST(FlipBack, RestoresEverySurfaceInItsOwnMetric) {
  for (const char* name : {"bumpy_terrain", "annulus", "blob", "double_torus", "capped_tube"}) {
    SCOPED_TRACE(name);
    const Surface surface = GeneratedSurface(name, 1000);
    const IntrinsicMesh input =
        testing::Scramble({surface.triangulation, MeasureEdgeLengths(surface)}, 300, 2);
    const IntrinsicTriangulation delaunay =
        MakeIntrinsicDelaunay(input.triangulation, input.lengths);
    ASSERT_GT(delaunay.flips.size(), 30);
    ExpectRestored(input, FlipBack(delaunay, delaunay.lengths), 1e-12);
  }
}

TEST(FlipBack, RestoresASingleVertexTorus) {
  const IntrinsicMesh input = testing::LatticeTorus({1, 0}, {7.3, 0.9});
  const IntrinsicTriangulation delaunay = MakeIntrinsicDelaunay(input.triangulation, input.lengths);
  ASSERT_EQ(delaunay.flips.size(), 8);
  ExpectRestored(input, FlipBack(delaunay, delaunay.lengths), 1e-12);
}

/// Two triangles a b c and b a d in the plane.
IntrinsicMesh Quad(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                   const Eigen::Vector2d& d) {
  IntrinsicMesh quad;
  quad.triangulation = NumberEdges(4, {2, 0, 1, 3, 1, 0}, {3, kNone, kNone, 0, kNone, kNone});
  const Eigen::Vector2d at[] = {a, b, c, d};
  const Triangulation& t = quad.triangulation;
  quad.lengths.value.resize(t.num_edges());
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    quad.lengths.value[e] = (at[t.Tip(h)] - at[t.Tail(h)]).norm();
  }
  return quad;
}

TEST(FlipBack, AnEdgeWhoseQuadIsNotConvexStays) {
  const IntrinsicMesh input = Quad({-2, 0}, {2, 0}, {0, 1}, {0, -1});
  const IntrinsicTriangulation delaunay = MakeIntrinsicDelaunay(input.triangulation, input.lengths);
  ASSERT_EQ(delaunay.flips.size(), 1);
  // In the flat metric c lies below the line from a to b, or exactly on it.
  for (const double height : {-0.5, 0.0}) {
    const IntrinsicMesh dented = Quad({-2, 0}, {2, 0}, {0, height}, {0, -1});
    EdgeLengths flat;
    flat.value.resize(5);
    const Triangulation& t = delaunay.triangulation;
    for (Index e = 0; e < 5; ++e) {
      for (Index h = 0; h < 6; ++h) {
        const Triangulation& u = dented.triangulation;
        const Index g = t.edge_halfedge[e];
        if (std::minmax(t.Tail(g), t.Tip(g)) == std::minmax(u.Tail(h), u.Tip(h))) {
          flat.value[e] = dented.lengths.value[u.edge[h]];
        }
      }
    }
    const Index diagonal = t.edge[delaunay.flips[0]];
    flat.value[diagonal] = 1 + height;
    const FlippedBack back = FlipBack(delaunay, flat);
    EXPECT_EQ(back.stuck, std::vector<Index>{diagonal});
    EXPECT_EQ(back.triangulation.vertex, t.vertex);
    EXPECT_EQ(back.lengths.value, flat.value);
  }
}

TEST(FlipBack, WhatDependsOnAStuckEdgeStaysTooAndAllOfItIsListed) {
  const Surface patch = GeneratedSurface("flat_delaunay_patch", 2000);
  const IntrinsicMesh input =
      testing::Scramble({patch.triangulation, MeasureEdgeLengths(patch)}, 3000, 1);
  const IntrinsicTriangulation delaunay = MakeIntrinsicDelaunay(input.triangulation, input.lengths);
  // Another flat metric: the same triangles in a sheared plane, none of them flipped.
  const Triangulation& t = delaunay.triangulation;
  std::vector<Eigen::Vector2d> at;
  for (Index v = 0; v < t.num_vertices; ++v) {
    const Eigen::Vector3d& p = patch.position[v];
    at.emplace_back(p.x() + 0.3 * std::sin(5 * p.y()), p.y() + 0.1 * std::sin(4 * p.x()));
  }
  for (Index h = 0; h < t.num_halfedges(); h += 3) {
    ASSERT_EQ(OrientationSign(at[t.vertex[h]], at[t.vertex[h + 1]], at[t.vertex[h + 2]]), 1);
  }
  EdgeLengths flat;
  flat.value.resize(t.num_edges());
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    flat.value[e] = (at[t.Tip(h)] - at[t.Tail(h)]).norm();
  }
  const FlippedBack back = FlipBack(delaunay, flat);
  const Triangulation& u = back.triangulation;
  std::multiset<std::pair<Index, Index>> inputs;
  for (const Index h : input.triangulation.edge_halfedge) {
    inputs.insert(std::minmax(input.triangulation.Tail(h), input.triangulation.Tip(h)));
  }
  std::vector<Index> strangers;
  for (Index e = 0; e < u.num_edges(); ++e) {
    const Index h = u.edge_halfedge[e];
    if (inputs.count(std::minmax(u.Tail(h), u.Tip(h))) == 0) strangers.push_back(e);
    EXPECT_NEAR(back.lengths.value[e], (at[u.Tip(h)] - at[u.Tail(h)]).norm(), 1e-12);
  }
  EXPECT_EQ(back.stuck, strangers);
  EXPECT_GT(back.stuck.size(), 5);
  EXPECT_LT(back.stuck.size(), delaunay.flips.size());
}

}  // namespace
}  // namespace cirque

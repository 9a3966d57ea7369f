// Flips of chosen edges in the metric of a surface.
#include "cirque/intrinsic/flip_edges.h"

#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "cirque/intrinsic/intrinsic_surface.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

const KeepFlip kAlways = [](const FlipComplex&, Index) { return true; };

class FlipEdgesOf : public testing::TestWithParam<const char*> {
 protected:
  FlipEdgesOf() : surface_(GeneratedSurface(GetParam(), 500)) {
    from_ = MakeIntrinsicDelaunay(surface_.triangulation, MeasureEdgeLengths(surface_));
    all_.resize(from_.triangulation.num_edges());
    std::iota(all_.begin(), all_.end(), 0);
  }

  const Triangulation& t() const { return from_.triangulation; }

  Surface surface_;
  IntrinsicTriangulation from_;
  std::vector<Index> all_;
};

double Area(const IntrinsicTriangulation& of) {
  const CornerAngles angles = MeasureCornerAngles(of.triangulation, of.lengths);
  double area = 0;
  for (Index h = 0; h < of.triangulation.num_halfedges(); h += 3) {
    area += 0.5 * of.lengths.value[of.triangulation.edge[h]] *
            of.lengths.value[of.triangulation.edge[h + 1]] * std::sin(angles.value[h + 2]);
  }
  return area;
}

/// Angle sums at the vertices and the area belong to the metric.
TEST_P(FlipEdgesOf, KeepsTheMetric) {
  const IntrinsicTriangulation to =
      FlipEdges(from_, all_, FreeBoundaryTargets(surface_.triangulation), kAlways);
  EXPECT_GT(to.flips.size(), from_.flips.size() + 20);
  const auto before = VertexAngleSums(t(), MeasureCornerAngles(t(), from_.lengths));
  const auto after =
      VertexAngleSums(to.triangulation, MeasureCornerAngles(to.triangulation, to.lengths));
  for (std::size_t v = 0; v < before.size(); ++v) EXPECT_NEAR(before[v], after[v], 1e-9);
  EXPECT_NEAR(Area(to), Area(from_), 1e-9 * Area(from_));
  EXPECT_EQ(EulerCharacteristic(to.triangulation), EulerCharacteristic(t()));
}

/// Edges of the input keep their lengths where they are said to be still there.
TEST_P(FlipEdgesOf, TellsWhichEdgesAreLeft) {
  const IntrinsicTriangulation to =
      FlipEdges(from_, all_, FreeBoundaryTargets(surface_.triangulation), kAlways);
  std::size_t left = 0;
  for (std::size_t e = 0; e < from_.edge_of_input.size(); ++e) {
    if (to.edge_of_input[e] == kNone) continue;
    ++left;
    ASSERT_NE(from_.edge_of_input[e], kNone);
    EXPECT_EQ(to.lengths.value[to.edge_of_input[e]], from_.lengths.value[from_.edge_of_input[e]]);
  }
  EXPECT_GT(left, 0u);
  EXPECT_LT(left, from_.edge_of_input.size());
}

TEST_P(FlipEdgesOf, LeavesVerticesCornersEnough) {
  const ConeTargets targets = FreeBoundaryTargets(surface_.triangulation);
  IntrinsicTriangulation to = from_;
  for (int round = 0; round < 5; ++round) to = FlipEdges(to, all_, targets, kAlways);
  const std::vector<Index> corners = CornersPerVertex(to.triangulation);
  for (Index v = 0; v < t().num_vertices; ++v) EXPECT_GT(corners[v] * kPi, targets.lower[v]);
}

TEST_P(FlipEdgesOf, WhatIsNotKeptIsAsItWas) {
  const IntrinsicTriangulation to =
      FlipEdges(from_, all_, FreeBoundaryTargets(surface_.triangulation),
                [](const FlipComplex&, Index) { return false; });
  EXPECT_EQ(to.flips, from_.flips);
  EXPECT_EQ(to.triangulation.vertex, t().vertex);
  EXPECT_EQ(to.triangulation.twin, t().twin);
  EXPECT_EQ(to.edge_of_input, from_.edge_of_input);
  EXPECT_EQ(to.lengths.value, from_.lengths.value);
}

INSTANTIATE_TEST_SUITE_P(Surfaces, FlipEdgesOf,
                         testing::Values("bumpy_terrain", "torus", "blob", "catenoid"));

}  // namespace
}  // namespace cirque

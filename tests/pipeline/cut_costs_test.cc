#include "cirque/pipeline/cut_costs.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/cuts/shortest_path.h"
#include "cirque/mesh/surface.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

TEST(CutCosts, MissingFilesAreRefused) {
  const Surface strip = FlatStrip(2, 2);
  const EdgeLengths lengths = MeasureEdgeLengths(strip);
  ParameterizeOptions options;
  options.edge_costs = testing::TempDir() + "no_such_costs.txt";
  const IntrinsicSurface surface = MeasureSurface(strip.triangulation, lengths);
  const auto costs = CutCosts({surface, lengths}, options, strip.soup_vertex);
  EXPECT_EQ(costs.status().code(), StatusCode::kInvalidInput);
  EXPECT_THAT(costs.status().message(), HasSubstr("no_such_costs.txt"));
}

TEST(RelativeCutLength, IsTheLengthOverTheRootOfTheArea) {
  const Surface strip = FlatStrip(8, 2);  // of area 16
  const Triangulation& t = strip.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(strip);
  const IntrinsicSurface surface = MeasureSurface(t, lengths);
  Cut cut = {std::vector<bool>(t.num_edges(), false)};
  EXPECT_EQ(RelativeCutLength(surface, cut), 0);
  // Along the middle from end to end: 8 edges of length 1.
  const auto straight = CutAlongShortestPaths(t, lengths.value, {{9, 17}});
  ASSERT_TRUE(straight.ok()) << straight.status().message();
  EXPECT_NEAR(RelativeCutLength(surface, *straight), 8 / std::sqrt(16), 1e-12);
  // Edges of the boundary are open already.
  for (Index e = 0; e < t.num_edges(); ++e) cut.edge[e] = t.IsBoundaryEdge(e);
  EXPECT_EQ(RelativeCutLength(surface, cut), 0);
}

TEST(VisibleCutLength, CountsEdgesByWhoSeesThem) {
  // Every edge of a sheet is seen from one side.
  const Surface strip = FlatStrip(8, 2);
  const Triangulation& t = strip.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(strip);
  const IntrinsicSurface surface = MeasureSurface(t, lengths);
  const auto straight = CutAlongShortestPaths(t, lengths.value, {{9, 17}});
  ASSERT_TRUE(straight.ok()) << straight.status().message();
  EXPECT_NEAR(VisibleCutLength(surface, strip.position, *straight), 1, 1e-12);
  EXPECT_EQ(VisibleCutLength(surface, strip.position, {std::vector<bool>(t.num_edges(), false)}),
            0);
}

}  // namespace
}  // namespace cirque

#include "cirque/cuts/shortest_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

TEST(ShortestPath, AcrossAHexagonIsStraight) {
  // Equilateral, edges of length 1: a hexagon of side 5. Opposite corners are 10 edges apart.
  const Surface hexagon = GeneratedSurface("hexagonal_fan", 150);
  const Triangulation& t = hexagon.triangulation;
  const Eigen::VectorXd lengths = MeasureEdgeLengths(hexagon).value;
  Index west = 0, east = 0;
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (hexagon.position[v].x() < hexagon.position[west].x()) west = v;
    if (hexagon.position[v].x() > hexagon.position[east].x()) east = v;
  }
  const auto path = ShortestPath(t, lengths, west, east);
  ASSERT_TRUE(path.ok());
  ASSERT_EQ(path->size(), 10u);
  for (const Index e : *path) EXPECT_NEAR(hexagon.position[t.Tip(t.edge_halfedge[e])].y(), 0, 1e-9);
  const auto cut = CutAlongShortestPaths(t, lengths, {{west, east}, {east, west}});
  EXPECT_EQ(std::count(cut->edge.begin(), cut->edge.end(), true), 10);
  EXPECT_EQ(ConnectedPatches(CutOpen(t, *cut)).count, 2);
}

TEST(ShortestPath, ForestGivesEveryVertexItsNearestSource) {
  const Surface surface = GeneratedSurface("bumpy_terrain", 400);
  const Triangulation& t = surface.triangulation;
  const Eigen::VectorXd lengths = MeasureEdgeLengths(surface).value;
  const EdgeGraph graph(t);
  const std::vector<Index> sources = {0, 50, 150};
  const ShortestPathForest all = GrowShortestPaths(graph, lengths, sources);
  for (Index v = 0; v < t.num_vertices; ++v) {
    double nearest = 1e9;
    for (const Index s : sources) {
      nearest = std::min(nearest, GrowShortestPaths(graph, lengths, {s}).distance[v]);
    }
    EXPECT_NEAR(all.distance[v], nearest, 1e-12);
    EXPECT_NEAR(GrowShortestPaths(graph, lengths, {all.source[v]}).distance[v], nearest, 1e-12);
  }
}

TEST(ShortestPath, VerticesThatDoNotExistAreNamed) {
  const Surface fan = Fan(5, 0);
  const auto path = ShortestPath(fan.triangulation, MeasureEdgeLengths(fan).value, 0, 6);
  EXPECT_THAT(path.status().message(), testing::HasSubstr("no vertex 6 (0-based)"));
}

}  // namespace
}  // namespace cirque

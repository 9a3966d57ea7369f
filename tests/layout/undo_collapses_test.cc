#include "cirque/layout/undo_collapses.h"

#include <cmath>
#include <complex>

#include <gtest/gtest.h>

#include "cirque/mesh/coarsen.h"
#include "cirque/metrics/injectivity.h"

#include "tests/common/collapsed_maps.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

CollapsedMap Carried(const Surface& plane, CoarseSurface coarse, CollapsedMap map) {
  const std::size_t count = coarse.collapses.size();
  const StatusOr<Index> retreats = UndoCollapses(plane.position, count, &coarse.collapses, &map);
  EXPECT_TRUE(retreats.ok()) << retreats.status().message();
  EXPECT_EQ(coarse.collapses.size(), 0u);
  return map;
}

// A similarity distorts nothing, so every vertex has its own place back.
TEST(UndoCollapses, OfASimilarityGivesTheSimilarity) {
  const Surface plane = FlatStrip(24, 24);
  const CoarseSurface coarse = Coarsen(plane, 120);
  const auto turn = [](const Eigen::Vector3d& p) {
    return Eigen::Vector2d(0.6 * p.x() - 0.8 * p.y() + 3, 0.8 * p.x() + 0.6 * p.y() - 1);
  };
  const CollapsedMap map = Carried(plane, coarse, MapOfRest(plane, coarse, turn));
  for (Index c = 0; c < plane.triangulation.num_halfedges(); ++c) {
    const Index v = plane.triangulation.vertex[c];
    ASSERT_EQ(map.corner[c / 3][c % 3], v);
    EXPECT_LT((map.uv.value[c] - turn(plane.position[v])).norm(), 1e-10) << v;
  }
}

// In steps the way is the same.
TEST(UndoCollapses, InTwoStepsIsTheSame) {
  const Surface plane = FlatStrip(16, 16);
  CoarseSurface coarse = Coarsen(plane, 80);
  const auto bend = [](const Eigen::Vector3d& p) {
    return Eigen::Vector2d(p.x() + 0.01 * p.y() * p.y(), p.y());
  };
  const CollapsedMap start = MapOfRest(plane, coarse, bend);
  const CollapsedMap whole = Carried(plane, coarse, start);
  CollapsedMap half = start;
  ASSERT_TRUE(UndoCollapses(plane.position, 50, &coarse.collapses, &half).ok());
  EXPECT_EQ(Carried(plane, coarse, half).uv.value, whole.uv.value);
}

// Stretched a hundred times, the least squares lead out of many rings.
TEST(UndoCollapses, FlipsNothingWhereTheBestPlacesWould) {
  const Surface plane = FlatStrip(24, 24);
  CoarseSurface coarse = Coarsen(plane, 60);
  const auto bend = [](const Eigen::Vector3d& p) {
    return Eigen::Vector2d(100 * p.x() + 40 * p.y(), std::exp(p.y() / 4));
  };
  CollapsedMap map = MapOfRest(plane, coarse, bend);
  ASSERT_EQ(NumFlipped(map), 0u);
  const std::size_t count = coarse.collapses.size();
  const StatusOr<Index> retreats = UndoCollapses(plane.position, count, &coarse.collapses, &map);
  ASSERT_TRUE(retreats.ok()) << retreats.status().message();
  EXPECT_GT(*retreats, 0);
  EXPECT_EQ(NumFlipped(map), 0u);
  EXPECT_TRUE(FlippedFaces(plane.triangulation, map.uv).empty());
}

// Two halves in frames of their own: vertices come back in both, and the cut between the halves
// leads along the surface's edges from side to side.
TEST(UndoCollapses, LeadsACutAlongTheFineEdges) {
  const Surface plane = FlatStrip(24, 24);
  const CoarseSurface coarse = Coarsen(plane, 150);
  const CollapsedMap map = Carried(plane, coarse, TwoHalves(plane, coarse));
  const Triangulation& t = plane.triangulation;
  Index cut = 0;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const Eigen::Vector3d& p = plane.position[t.vertex[h]];
    const bool moved = IsMoved(map, h / 3);
    const Eigen::Vector2d expected = moved ? MovedHalf(p) : Eigen::Vector2d(p.x(), p.y());
    EXPECT_LT((map.uv.value[h] - expected).norm(), 1e-9) << h;
    if (t.twin[h] == kNone) continue;
    EXPECT_EQ(map.cut[h], moved != IsMoved(map, t.twin[h] / 3)) << h;
    cut += map.cut[h];
  }
  EXPECT_GE(cut, 2 * 24);  // both sides of at least as many edges as there are rows
}

TEST(UndoCollapses, RefusesWhatDoublesCannotHold) {
  const Surface plane = FlatStrip(8, 8);
  CoarseSurface coarse = Coarsen(plane, 40);
  ASSERT_GT(coarse.collapses.size(), 0u);
  // One point: no triangle has room.
  CollapsedMap map =
      MapOfRest(plane, coarse, [](const Eigen::Vector3d&) { return Eigen::Vector2d(1, 1); });
  const std::size_t count = coarse.collapses.size();
  EXPECT_EQ(UndoCollapses(plane.position, count, &coarse.collapses, &map).status().code(),
            StatusCode::kUnrepresentable);
}

}  // namespace
}  // namespace cirque

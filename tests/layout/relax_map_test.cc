#include "cirque/layout/relax_map.h"

#include <atomic>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "cirque/core/parallel.h"
#include "cirque/layout/undo_collapses.h"
#include "cirque/metrics/measure_map.h"

#include "tests/common/collapsed_maps.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

/// The surface with nothing collapsed.
CoarseSurface Whole(const Surface& surface) {
  return Coarsen(surface, surface.triangulation.num_faces());
}

Eigen::Vector2d Flat(const Eigen::Vector3d& p) { return {p.x(), p.y()}; }

/// Moved by a tenth of an edge, in no direction in particular.
Eigen::Vector2d Shaken(const Eigen::Vector3d& p) {
  const double at = 12.9898 * p.x() + 78.233 * p.y();
  return Flat(p) + 0.1 * Eigen::Vector2d(std::sin(43.7 * at), std::cos(17.3 * at));
}

double Distortion(const Surface& surface, const CollapsedMap& map) {
  return MeasureFigures(surface.triangulation, MeasureEdgeLengths(surface), map.uv,
                        {"quasi_conformal_mean"})
             ->at("quasi_conformal_mean") -
         1;
}

// With all vertices free a flat surface has maps without distortion, and the sweeps find one.
TEST(RelaxMap, TakesAwayWhatVerticesWereShakenBy) {
  const Surface plane = FlatStrip(12, 12);
  CollapsedMap map = MapOfRest(plane, Whole(plane), Shaken);
  const double before = Distortion(plane, map);
  ASSERT_GT(before, 0.1);
  RelaxMap(plane.position, 3, nullptr, &map);
  EXPECT_LT(Distortion(plane, map), 0.25 * before);
  RelaxMap(plane.position, 300, nullptr, &map);
  EXPECT_LT(Distortion(plane, map), 0.01 * before);
}

TEST(RelaxMap, OfASimilarityLeavesIt) {
  const Surface plane = FlatStrip(6, 6);
  const CollapsedMap before = MapOfRest(plane, Whole(plane), Flat);
  CollapsedMap map = before;
  RelaxMap(plane.position, 10, nullptr, &map);
  for (std::size_t c = 0; c < map.uv.value.size(); ++c) {
    EXPECT_LT((map.uv.value[c] - before.uv.value[c]).norm(), 1e-12);
  }
}

TEST(RelaxMap, FlipsNothingAndLowersTheDistortionOfAWildMap) {
  const Surface plane = FlatStrip(12, 12);
  CollapsedMap map = MapOfRest(plane, Whole(plane), [](const Eigen::Vector3d& p) {
    return Eigen::Vector2d(100 * p.x() + 40 * p.y(), std::exp(p.y()));
  });
  ASSERT_EQ(NumFlipped(map), 0u);
  double mean = Distortion(plane, map);
  for (int i = 0; i < 4; ++i) {
    RelaxMap(plane.position, 10, nullptr, &map);
    EXPECT_EQ(NumFlipped(map), 0u);
    EXPECT_LT(Distortion(plane, map), mean);
    mean = Distortion(plane, map);
  }
}

// Shaken on both sides alike, the images stay each other's by the motion between the halves.
TEST(RelaxMap, KeepsTheSidesOfACutCongruent) {
  const Surface plane = FlatStrip(24, 24);
  CollapsedMap map = TwoHalves(plane, Whole(plane));
  for (Index c = 0; c < plane.triangulation.num_halfedges(); ++c) {
    const Eigen::Vector2d q = Shaken(plane.position[plane.triangulation.vertex[c]]);
    map.uv.value[c] = IsMoved(map, c / 3) ? MovedHalf({q.x(), q.y(), 0}) : q;
  }
  const double before = Distortion(plane, map);
  RelaxMap(plane.position, 60, nullptr, &map);
  EXPECT_LT(Distortion(plane, map), 0.1 * before);
  const Triangulation& t = plane.triangulation;
  Index cut = 0;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (!map.cut[h] || IsMoved(map, h / 3)) continue;
    ++cut;
    for (const auto& [c, d] : {std::pair(Triangulation::Next(h), Triangulation::Prev(t.twin[h])),
                               std::pair(Triangulation::Prev(h), Triangulation::Next(t.twin[h]))}) {
      const Eigen::Vector2d& p = map.uv.value[c];
      EXPECT_LT((map.uv.value[d] - MovedHalf({p.x(), p.y(), 0})).norm(), 1e-10);
    }
  }
  EXPECT_EQ(cut, 24);
}

// Five equilateral triangles around a vertex, opened along an edge: there the plane closes by a
// turn only, which no shift of the vertex keeps. One of the others is out of its place.
TEST(RelaxMap, LeavesConesWhereTheyAre) {
  const Surface cone = Fan(5, std::sqrt(4 * std::pow(std::sin(kPi / 5), 2) - 1));
  const Triangulation& t = cone.triangulation;
  CollapsedMap map = MapOfRest(cone, Whole(cone), Flat);
  const std::vector<Index> corners = CornersPerVertex(t);
  Index corner = 0;
  while (corners[t.vertex[corner]] != 5) ++corner;
  int turns = 0;
  const auto at = [](int turn) {
    const double radius = turn == 2 ? 1.2 : 1;
    return Eigen::Vector2d(radius * std::cos(turn * kPi / 3), radius * std::sin(turn * kPi / 3));
  };
  t.ForEachCornerAround(corner, [&](Index c) {
    map.uv.value[c] = {0, 0};
    map.uv.value[Triangulation::Next(c)] = at(turns);
    map.uv.value[Triangulation::Prev(c)] = at(++turns);
  });
  ASSERT_EQ(turns, 5);
  const Index cut = Triangulation::Prev(corner);  // to the first of the ring
  map.cut[cut] = map.cut[t.twin[cut]] = true;
  const double before = Distortion(cone, map);
  RelaxMap(cone.position, 50, nullptr, &map);
  t.ForEachCornerAround(corner,
                        [&](Index c) { EXPECT_EQ(map.uv.value[c], Eigen::Vector2d(0, 0)); });
  EXPECT_LT(Distortion(cone, map), 0.1 * before);
  // The vertex at the end of the cut has its other image turned by as much as the cone lacks.
  const Eigen::Vector2d& p = map.uv.value[Triangulation::Next(corner)];
  const Eigen::Vector2d& q = map.uv.value[Triangulation::Next(t.twin[cut])];
  EXPECT_LT((q - Eigen::Rotation2Dd(-kPi / 3) * p).norm(), 1e-12);
}

TEST(RelaxMap, DoesNotDependOnThreads) {
  const Surface plane = FlatStrip(20, 20);
  const CollapsedMap start = MapOfRest(plane, Whole(plane), Shaken);
  CollapsedMap one = start, several = start;
  {
    const ThreadLimit limit(1);
    RelaxMap(plane.position, 5, nullptr, &one);
  }
  RelaxMap(plane.position, 5, nullptr, &several);
  EXPECT_EQ(one.uv.value, several.uv.value);
  const std::atomic<bool> cancelled = true;
  CollapsedMap stopped = start;
  RelaxMap(plane.position, 5, &cancelled, &stopped);
  EXPECT_EQ(stopped.uv.value, start.uv.value);
}

}  // namespace
}  // namespace cirque

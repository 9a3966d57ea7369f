#include "cirque/layout/exact_map.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "cirque/intrinsic/intrinsic_delaunay.h"
#include "cirque/intrinsic/overlay.h"
#include "cirque/intrinsic/straight_lines.h"
#include "cirque/math/predicates.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

/// A sheared flat patch, the triangulation it is flipped to, and its points as UVs there.
struct Sheared {
  Surface surface;
  IntrinsicTriangulation flipped;
  CornerUv uv;
  Cut cut;

  explicit Sheared(const Eigen::Vector2d& shift) {
    surface = Moved(GeneratedSurface("flat_delaunay_patch", 300),
                    [](auto x) { return Eigen::Vector3d(x.x() + 1.7 * x.y(), x.y(), 0); });
    flipped = MakeIntrinsicDelaunay(surface.triangulation, MeasureEdgeLengths(surface));
    for (const Index v : flipped.triangulation.vertex) {
      uv.value.push_back(surface.position[v].head<2>() + shift);
    }
    cut.edge.assign(flipped.triangulation.num_edges(), false);
  }

  Overlay MakeOverlayBy(const PositionRule& rule) const {
    return *MakeOverlay(surface.triangulation, flipped.flips, rule, 100000);
  }

  StatusOr<ExactMap> Make(const PositionRule& rule, ExactMapRepair* repair) const {
    return MakeExactMap(surface.triangulation, flipped.triangulation, cut, uv, MakeOverlayBy(rule),
                        repair);
  }
};

void ExpectPositive(const ExactMap& map) {
  for (Index t = 0; t < map.num_triangles(); ++t) {
    const auto at = [&](int k) { return map.uv[map.corner_uv[3 * t + k]]; };
    EXPECT_EQ(OrientationSign(at(0), at(1), at(2)), 1);
  }
}

TEST(ExactMap, PutsPointsOfTheSurfaceWhereTheMapHasThem) {
  const Sheared patch({0, 0});
  ExactMapRepair repair;
  const auto map =
      patch.Make(StraightLines(patch.flipped.triangulation, patch.flipped.lengths), &repair);
  ASSERT_TRUE(map.ok());
  ExpectPositive(*map);
  EXPECT_EQ(repair.edges_spread, 0);
  EXPECT_EQ(repair.largest_shift, 0);
  const Triangulation& t = patch.surface.triangulation;
  for (std::size_t c = 0; c < map->corner.size(); ++c) {
    const SurfacePoint& point = map->point[map->corner[c]];
    Eigen::Vector2d place(0, 0);
    for (int k = 0; k < 3; ++k) {
      place +=
          point.barycentric[k] * patch.surface.position[t.vertex[3 * point.face + k]].head<2>();
    }
    EXPECT_LT((map->uv[map->corner_uv[c]] - place).norm(), 1e-12);
  }
  // Continuous: a point for every vertex and every crossing.
  EXPECT_EQ(map->uv.size(), map->point.size());
  EXPECT_TRUE(std::is_sorted(map->face_of_input.begin(), map->face_of_input.end()));
}

TEST(ExactMap, MovesCrossingsApartWhereRoundingWouldJoinThem) {
  // All at the beginning of their edges, and in coordinates of few digits.
  const PositionRule crowded = [](const EdgePath& path) -> PathPositions {
    const std::vector<double> none(path.crossed.size(), 0.0);
    return {none, none};
  };
  const Sheared patch({1e6, 0});
  ExactMapRepair repair;
  const auto map = patch.Make(crowded, &repair);
  ASSERT_TRUE(map.ok()) << map.status().message();
  ExpectPositive(*map);
  EXPECT_GT(repair.edges_spread, 10);
  EXPECT_GT(repair.largest_shift, 1e-10);
}

TEST(ExactMap, IsRefusedWhereFacesHaveNoRoomForCrossings) {
  Sheared patch({0, 0});
  // Upright triangles of a few units in the last place.
  for (Eigen::Vector2d& uv : patch.uv.value) uv = 1e-15 * uv + Eigen::Vector2d(1, 1);
  ExactMapRepair repair;
  const auto map =
      patch.Make(StraightLines(patch.flipped.triangulation, patch.flipped.lengths), &repair);
  EXPECT_EQ(map.status().code(), StatusCode::kUnrepresentable);
}

TEST(ExactMap, TellsTheTwoSidesOfASeamApart) {
  Sheared patch({0, 0});
  const Triangulation& t = patch.flipped.triangulation;
  Overlay overlay = patch.MakeOverlayBy(StraightLines(t, patch.flipped.lengths));
  ASSERT_FALSE(overlay.crossing.empty());
  const Index h = overlay.crossing.front().other, e = t.edge[h];
  const auto crossings =
      std::count_if(overlay.crossing.begin(), overlay.crossing.end(),
                    [&](const Crossing& crossing) { return t.edge[crossing.other] == e; });
  patch.cut.edge[e] = true;
  ExactMapRepair repair;
  const auto map =
      MakeExactMap(patch.surface.triangulation, t, patch.cut, patch.uv, overlay, &repair);
  ASSERT_TRUE(map.ok());
  ExpectPositive(*map);
  EXPECT_EQ(map->uv.size(),
            map->point.size() + crossings + (CutOpen(t, patch.cut).num_vertices - t.num_vertices));
}

}  // namespace
}  // namespace cirque

#include "cirque/layout/exact_map.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>
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

/// The same surface on the sphere, where its faces are not flipped.
std::vector<Eigen::Vector3d> OnSphere(const Surface& surface) {
  std::vector<Eigen::Vector3d> position;
  for (const Eigen::Vector3d& x : surface.position) {
    position.push_back(Eigen::Vector3d(0.2 * x.x(), 0.2 * x.y(), 1).normalized());
  }
  return position;
}

TEST(ExactMap, LiesOnTheSphereAlongGreatCircles) {
  const Sheared patch({0, 0});
  const std::vector<Eigen::Vector3d> position = OnSphere(patch.surface);
  const Triangulation& t = patch.flipped.triangulation;
  const Overlay overlay = patch.MakeOverlayBy(StraightLines(t, patch.flipped.lengths));
  ExactMapRepair repair;
  const auto map = MakeExactSphereMap(patch.surface.triangulation, t, position, overlay, &repair);
  ASSERT_TRUE(map.ok()) << map.status().message();
  EXPECT_TRUE(map->uv.empty() && map->corner_uv.empty());
  ASSERT_EQ(map->position.size(), map->point.size());
  for (const Eigen::Vector3d& x : map->position) EXPECT_NEAR(x.norm(), 1, 1e-15);
  for (Index v = 0; v < t.num_vertices; ++v) EXPECT_EQ(map->position[v], position[v]);
  for (std::size_t i = 0; i < overlay.crossing.size(); ++i) {
    const Index h = overlay.crossing[i].other;
    const Eigen::Vector3d normal = position[t.Tail(h)].cross(position[t.Tip(h)]).normalized();
    EXPECT_NEAR(normal.dot(map->position[overlay.num_vertices + i]), 0, 1e-14);
  }
  for (std::size_t c = 0; c < map->corner.size(); c += 3) {
    const auto at = [&](int k) { return map->position[map->corner[c + k]]; };
    EXPECT_EQ(OrientationSign3(at(0), at(1), at(2), Eigen::Vector3d::Zero()), -1);
  }
}

TEST(ExactMap, OnAGridTheTwoSidesOfASeamDifferByItsTranslationExactly) {
  Sheared patch({0, 0});
  const Triangulation& t = patch.flipped.triangulation;
  const Overlay overlay = patch.MakeOverlayBy(StraightLines(t, patch.flipped.lengths));
  ASSERT_FALSE(overlay.crossing.empty());
  // Coordinates of 2^-40; one whole face moved away by a number of such.
  for (Eigen::Vector2d& uv : patch.uv.value) {
    uv = {std::ldexp(std::round(std::ldexp(uv.x(), 40)), -40),
          std::ldexp(std::round(std::ldexp(uv.y(), 40)), -40)};
  }
  const Eigen::Vector2d shift(std::ldexp(std::round(std::ldexp(100 / 3.0, 40)), -40), 0);
  const Index f = Triangulation::Face(overlay.crossing.front().other);
  for (Index h = 3 * f; h < 3 * f + 3; ++h) {
    patch.uv.value[h] += shift;
    patch.cut.edge[t.edge[h]] = true;
  }
  ExactMapRepair repair;
  const auto map =
      MakeExactMap(patch.surface.triangulation, t, patch.cut, patch.uv, overlay, &repair, -40);
  ASSERT_TRUE(map.ok()) << map.status().message();
  ExpectPositive(*map);
  std::vector<Eigen::Vector2d> inside(map->point.size(), {-9, -9}), outside = inside;
  for (std::size_t c = 0; c < map->corner.size(); ++c) {
    auto& side = map->face_of_solved[c / 3] == f ? inside : outside;
    side[map->corner[c]] = map->uv[map->corner_uv[c]];
  }
  int compared = 0;
  for (std::size_t p = 0; p < map->point.size(); ++p) {
    if (inside[p].x() == -9 || outside[p].x() == -9) continue;
    EXPECT_EQ(inside[p], outside[p] + shift);
    ++compared;
  }
  EXPECT_GT(compared, 3);
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

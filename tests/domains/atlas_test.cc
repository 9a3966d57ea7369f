#include "cirque/domains/atlas.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "cirque/core/triangulation.h"
#include "cirque/layout/packing.h"
#include "cirque/metrics/injectivity.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

TEST(AreaOf, OfTrianglesThatAreKnown) {
  const CornerUv half{{{1, 1}, {2, 1}, {1, 2}}}, turned{{{1, 1}, {1, 2}, {2, 1}}};
  EXPECT_EQ(AreaOf(half), 0.5);
  EXPECT_EQ(AreaOf(turned), -0.5);
  Surface tilted = FlatStrip(1, 1);
  const double before = AreaOf(tilted);
  EXPECT_NEAR(before, 1, 1e-14);
  for (Eigen::Vector3d& p : tilted.position) p = 3 * Eigen::Vector3d(p.y(), p.z(), p.x());
  EXPECT_NEAR(AreaOf(tilted), 9 * before, 1e-14);
}

/// Two flat pieces whose images are as wrong in size as may be.
struct TwoStrips {
  Surface small = FlatStrip(2, 2), large = FlatStrip(6, 4);
  CornerUv small_uv, large_uv;
  Cut none;

  TwoStrips() {
    for (const Index v : small.triangulation.vertex) {
      small_uv.value.push_back(100 * small.position[v].head<2>());
    }
    for (const Index v : large.triangulation.vertex) {
      large_uv.value.push_back(0.01 * large.position[v].head<2>());
    }
  }

  ArrangedAtlas Arrange(const UvFrame& frame) {
    return ArrangeAtlas(frame, {{small, none, &small_uv}, {large, none, &large_uv}});
  }
};

TEST(ArrangeAtlas, TrueLengthKeepsEverySurfacesArea) {
  TwoStrips strips;
  const ArrangedAtlas atlas = strips.Arrange({});
  EXPECT_NEAR(AreaOf(strips.small_uv), 4, 1e-12);
  EXPECT_NEAR(AreaOf(strips.large_uv), 24, 1e-12);
  EXPECT_EQ(atlas.patches, 2);
  EXPECT_GT(atlas.area_used, 0.5);
  EXPECT_LT(atlas.area_used, 1);
}

TEST(ArrangeAtlas, SaysWhichPiecesLoseTriangles) {
  TwoStrips strips;
  EXPECT_TRUE(strips.Arrange({}).lost.empty());
  TwoStrips fine;
  // Of squares that halve in size 60 times the last lie where doubles near 1 do not tell apart.
  const Triangulation& t = fine.large.triangulation;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const Eigen::Vector3d& p = fine.large.position[t.vertex[h]];
    fine.large_uv.value[h] = std::exp2(-10 * p.x()) * Eigen::Vector2d(-1, 0.1 * (p.y() - 2));
  }
  EXPECT_TRUE(FlippedFaces(t, fine.large_uv).empty());
  EXPECT_EQ(fine.Arrange({}).lost, std::vector<std::size_t>{1});
}

TEST(ArrangeAtlas, ScalesAndUnitSquareAndEachInOneSize) {
  TwoStrips scaled;
  scaled.Arrange({UvSize::kScale, 10});
  EXPECT_NEAR(AreaOf(scaled.large_uv), 2400, 1e-9);
  TwoStrips unit;
  unit.Arrange({UvSize::kUnit, 1, 0.05});
  double least = 1, greatest = 0;
  for (const CornerUv* uv : {&unit.small_uv, &unit.large_uv}) {
    for (const Eigen::Vector2d& p : uv->value) {
      least = std::min(least, p.minCoeff());
      greatest = std::max(greatest, p.maxCoeff());
    }
  }
  EXPECT_NEAR(least, 0.05, 1e-12);
  EXPECT_NEAR(greatest, 0.95, 1e-9);
  EXPECT_NEAR(AreaOf(unit.large_uv) / AreaOf(unit.small_uv), 6, 1e-9);
  TwoStrips each;
  each.Arrange({UvSize::kAsIs, 1, 0.01, PieceScale::kEach});
  EXPECT_NEAR(AreaOf(each.small_uv), AreaOf(each.large_uv), 1e-9);
}

TEST(ArrangeAtlas, ASinglePieceStaysWhereItIsUnlessTold) {
  TwoStrips strips;
  const CornerUv before = strips.large_uv;
  ArrangeAtlas({}, {{strips.large, strips.none, &strips.large_uv}});
  EXPECT_EQ(strips.large_uv.value, before.value);
  ArrangeAtlas({UvSize::kUnit, 1, 0}, {{strips.large, strips.none, &strips.large_uv}});
  EXPECT_NEAR(AreaOf(strips.large_uv), 4. / 6, 1e-9);
}

TEST(Joined, IsAllOfThemAndMeasuresAsOne) {
  const std::vector<Surface> surfaces = {FlatStrip(2, 2), GeneratedSurface("bumpy_terrain", 400),
                                         FlatStrip(6, 2)};
  const Surface joined = Joined({&surfaces[0], &surfaces[1], &surfaces[2]});
  Index faces = 0, edges = 0;
  for (const Surface& surface : surfaces) {
    faces += surface.triangulation.num_faces();
    edges += surface.triangulation.num_edges();
  }
  EXPECT_EQ(joined.triangulation.num_faces(), faces);
  EXPECT_EQ(joined.triangulation.num_edges(), edges);
  EXPECT_EQ(ConnectedPatches(joined.triangulation).count, 3);
}

/// A triangle as a map of itself.
ExactMap OneTriangle(const std::vector<Eigen::Vector2d>& uv) {
  ExactMap map;
  for (int k = 0; k < 3; ++k) map.point.push_back({0, Eigen::Vector3d::Unit(k)});
  map.uv = uv;
  map.corner = map.corner_uv = {0, 1, 2};
  map.face_of_input = map.face_of_solved = {0};
  return map;
}

TEST(ArrangeAtlas, ExactMapsAreArrangedOrLeftWhereRoundingWouldTurnThem) {
  const Surface half = *SurfaceFromTriangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  ExactMap a = OneTriangle({{0, 0}, {2, 0}, {0, 2}}), b = a;
  ASSERT_TRUE(ArrangeAtlas({}, {{half, &a}, {half, &b}}).ok());
  for (const ExactMap* map : {&a, &b}) {
    EXPECT_NEAR(AreaOf(CornerUv{map->uv}), 0.5, 1e-14);  // that of its surface
  }
  EXPECT_GT((a.uv[0] - b.uv[0]).norm(), 0.5);
  const ExactMap both = Joined({{half, &a}, {half, &b}});
  EXPECT_EQ(both.face_of_input, (std::vector<Index>{0, 1}));
  EXPECT_EQ(both.corner, (std::vector<Index>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(both.point[4].face, 1);
  EXPECT_EQ(both.uv[4], b.uv[1]);
  ExactMap thin = OneTriangle({{0, 0}, {1, 0}, {0.5, 1e-300}}), other = OneTriangle(a.uv);
  const std::vector<Eigen::Vector2d> before = thin.uv;
  const Status status = ArrangeAtlas({UvSize::kUnit}, {{half, &thin}, {half, &other}});
  EXPECT_EQ(status.code(), StatusCode::kUnrepresentable);
  EXPECT_EQ(thin.uv, before);
}

}  // namespace
}  // namespace cirque

#include "cirque/domains/map_decimated.h"

#include <atomic>
#include <cmath>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/cuts/cut_graph.h"
#include "cirque/metrics/injectivity.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

MapRequest SolvedAt(int faces) {
  MapRequest request;
  request.options.solve_at = faces;
  return request;
}

TEST(MapDecimated, MapsAsWellAsTheWholeSolve) {
  const Surface surface = GeneratedSurface("bumpy_terrain", 6000);
  const auto whole = MapSurface(surface, SolvedAt(10000));
  const auto decimated = MapSurface(surface, SolvedAt(1000));
  ASSERT_TRUE(whole.ok()) << whole.status().message();
  ASSERT_TRUE(decimated.ok()) << decimated.status().message();
  EXPECT_FALSE(whole->certificate.decimated_solve);
  const Certificate& certificate = decimated->certificate;
  ASSERT_TRUE(certificate.decimated_solve);
  EXPECT_NEAR(certificate.decimated_solve->solved_faces, 1000, 20);
  EXPECT_GT(certificate.decimated_solve->collapses, 2000);
  EXPECT_EQ(certificate.outcome, "ok");
  EXPECT_EQ(certificate.overlap, whole->certificate.overlap);
  EXPECT_TRUE(FlippedFaces(surface.triangulation, decimated->uv).empty());
  const double best = whole->certificate.distortion->quasi_conformal_mean;
  EXPECT_LT(certificate.distortion->quasi_conformal_mean - 1, 1.02 * (best - 1) + 0.001);
}

/// Cones with the angles that the certificate's own check finds, seams whose sides are congruent.
void ExpectSeamedMap(const Surface& surface, const SurfaceMap& map) {
  const Triangulation& t = surface.triangulation;
  EXPECT_TRUE(FlippedFaces(t, map.uv).empty());
  ASSERT_TRUE(map.certificate.seams);
  EXPECT_GT(map.certificate.seams->seams, 0);
  EXPECT_LT(map.certificate.seams->seam_length_mismatch, 1e-9);
  EXPECT_LT(map.certificate.seams->cone_rotation_mismatch, 1e-9);
  // Opened along the cut it is a disk, and continuous where it is not opened.
  const Triangulation open = CutOpen(t, map.cut);
  EXPECT_EQ(EulerCharacteristic(open), 1);
  std::vector<Index> corner(open.num_vertices, kNone);
  for (Index c = 0; c < open.num_halfedges(); ++c) {
    Index& first = corner[open.vertex[c]];
    if (first == kNone) first = c;
    EXPECT_EQ(map.uv.value[c], map.uv.value[first]);
  }
}

/// The angles at a vertex in the map.
double AngleSum(const Triangulation& t, const CornerUv& uv, Index v) {
  double sum = 0;
  for (Index c = 0; c < t.num_halfedges(); ++c) {
    if (t.vertex[c] != v) continue;
    const Eigen::Vector2d a = uv.value[Triangulation::Next(c)] - uv.value[c];
    const Eigen::Vector2d b = uv.value[Triangulation::Prev(c)] - uv.value[c];
    sum += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  return sum;
}

TEST(MapDecimated, CarriesConesAndSeamsBack) {
  for (const char* generator : {"sphere", "torus"}) {
    SCOPED_TRACE(generator);
    const Surface surface = GeneratedSurface(generator, 4000);
    const auto whole = MapSurface(surface, SolvedAt(0)), map = MapSurface(surface, SolvedAt(800));
    ASSERT_TRUE(map.ok()) << map.status().message();
    ASSERT_TRUE(map->certificate.decimated_solve);
    ExpectSeamedMap(surface, *map);
    const Triangulation& t = surface.triangulation;
    const std::vector<Index> cones = ConeVertices(BoundaryVertices(t), map->targets);
    EXPECT_EQ(static_cast<int>(cones.size()), map->certificate.layout->cones);
    for (const Index v : cones) {
      EXPECT_NEAR(AngleSum(t, map->uv, v), map->targets.lower[v], 1e-7);
    }
    EXPECT_LT(map->certificate.distortion->quasi_conformal_mean,
              whole->certificate.distortion->quasi_conformal_mean + 0.02);
  }
}

TEST(MapDecimated, SeamsOfQuarterTurnsStayExact) {
  const Surface surface = GeneratedSurface("sphere", 4000);
  MapRequest request = SolvedAt(800);
  request.options.cones = "moving:cones=8";
  request.options.cone_angles = "pi/2";
  const auto map = MapSurface(surface, request);
  ASSERT_TRUE(map.ok()) << map.status().message();
  ExpectSeamedMap(surface, *map);
  EXPECT_EQ(map->certificate.layout->rotation_order, 4);
  EXPECT_LT(map->certificate.seams->seam_rotation_mismatch, 1e-9);
}

TEST(MapDecimated, ChartsComeBackSideBySide) {
  const Surface surface = GeneratedSurface("blob", 6000);
  MapRequest request = SolvedAt(800);
  request.options.least_charts = 5;
  const auto map = MapSurface(surface, request);
  ASSERT_TRUE(map.ok()) << map.status().message();
  const Triangulation& t = surface.triangulation;
  EXPECT_TRUE(FlippedFaces(t, map->uv).empty());
  const Patches patches = ConnectedPatches(CutOpen(t, map->cut));
  ASSERT_EQ(patches.count, 5);
  std::vector<Eigen::AlignedBox2d> boxes(5);
  for (Index c = 0; c < t.num_halfedges(); ++c) {
    boxes[patches.of_face[Triangulation::Face(c)]].extend(map->uv.value[c]);
  }
  for (Index p = 0; p < 5; ++p) {
    for (Index q = 0; q < p; ++q) EXPECT_FALSE(boxes[p].intersects(boxes[q]));
  }
}

TEST(MapDecimated, RefusesWhatIsAboutAllVertices) {
  const Surface surface = GeneratedSurface("bumpy_terrain", 500);
  const auto refusal = [&](const auto& change) {
    MapRequest request = SolvedAt(100);
    change(&request);
    Certificate failed;
    const auto map = MapSurface(surface, request, {}, &failed);
    EXPECT_EQ(map.status().code(), StatusCode::kInvalidInput);
    return map.status().message();
  };
  EXPECT_THAT(
      refusal([&](MapRequest* r) { r->targets = FreeBoundaryTargets(surface.triangulation); }),
      HasSubstr("solve_at takes no prescribed angle sums"));
  EXPECT_THAT(refusal([&](MapRequest* r) {
                r->cut = Cut{std::vector<bool>(surface.triangulation.num_edges(), false)};
              }),
              HasSubstr("solve_at takes no cut of your own"));
  EXPECT_THAT(refusal([](MapRequest* r) { r->options.exact = true; }), HasSubstr("exact map"));
  EXPECT_THAT(refusal([](MapRequest* r) { r->options.seams = SeamKind::kFree; }),
              HasSubstr("seams = free"));
  EXPECT_THAT(refusal([](MapRequest* r) { r->domain = "disk"; }),
              HasSubstr("the domain disk takes no solve_at"));
}

TEST(MapDecimated, IsCancelled) {
  const Surface surface = GeneratedSurface("bumpy_terrain", 3000);
  std::atomic<bool> cancelled = false;
  SolveControl control;
  control.cancelled = &cancelled;
  control.on_stage = [&](std::string_view stage) { cancelled = stage == "relaxation"; };
  EXPECT_EQ(MapSurface(surface, SolvedAt(500), control).status().code(), StatusCode::kCancelled);
}

}  // namespace
}  // namespace cirque

// Exact maps end to end: isometries of flat surfaces, and judged by the independent judge.
#include "cirque/domains/exact_mesh.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/domains/domain.h"
#include "cirque/metrics/injectivity.h"

#include "tests/common/exact_maps.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

MapRequest ExactRequest() {
  MapRequest request;
  request.options.exact = true;
  return request;
}

/// Long triangles, so that there is much to be flipped.
Surface Stretched(const std::string& generator, Index triangles, double by) {
  return Moved(GeneratedSurface(generator, triangles), [by](const Eigen::Vector3d& x) {
    return Eigen::Vector3d(x.x(), x.y(), by * x.z());
  });
}

void ExpectExactMap(const Surface& surface, const MapRequest& request) {
  const auto map = MapSurface(surface, request);
  ASSERT_TRUE(map.ok()) << map.status().message();
  ASSERT_TRUE(map->exact_map);
  EXPECT_GT(map->certificate.triangulation->flips, 10);
  EXPECT_GT(map->certificate.exact_map->exact_triangles, surface.triangulation.num_faces() + 20);
  ExpectExactMapIsAccepted(surface, *map);
}

TEST(ExactMesh, OfAFlatSurfaceIsAnIsometryOnEveryTriangle) {
  const Surface patch = Moved(GeneratedSurface("flat_delaunay_patch", 300), [](auto x) {
    return Eigen::Vector3d(x.x() + 1.7 * x.y(), x.y(), 0);
  });
  MapRequest request = ExactRequest();
  request.options.refine_map = "none";
  const auto map = MapSurface(patch, request);
  ASSERT_TRUE(map.ok());
  EXPECT_GT(map->certificate.triangulation->flips, 50);
  const ExactMesh exact = RefineByExactMap(TrianglesOf(patch), patch, *map->exact_map);
  for (Index p = 0; p < exact.mesh.num_polygons(); ++p) {
    for (Index c = 3 * p; c < 3 * p + 3; ++c) {
      const Index next = Triangulation::Next(c);
      const double length =
          (exact.mesh.position[exact.mesh.corner[c]] - exact.mesh.position[exact.mesh.corner[next]])
              .norm();
      const double image = (exact.mesh.texture[exact.mesh.corner_texture[c]] -
                            exact.mesh.texture[exact.mesh.corner_texture[next]])
                               .norm();
      EXPECT_NEAR(image, length, 1e-9);
    }
  }
  EXPECT_NEAR(map->certificate.exact_map->exact_quasi_conformal_max, 1, 1e-8);
}

TEST(ExactMesh, IsAValidMapOfDisksClosedSurfacesAndHandles) {
  ExpectExactMap(Stretched("bumpy_terrain", 600, 4), ExactRequest());
  ExpectExactMap(Stretched("sphere", 500, 5), ExactRequest());
  ExpectExactMap(Stretched("torus", 600, 4), ExactRequest());
}

TEST(ExactMesh, IsAValidMapWithFreeSeamsAndAlongAGivenCut) {
  const Surface torus = Stretched("torus", 600, 4);
  MapRequest free = ExactRequest();
  free.options.seams = SeamKind::kFree;
  free.options.cones = "greedy";
  ExpectExactMap(torus, free);
  const auto whole = MapSurface(torus, ExactRequest());
  ASSERT_TRUE(whole.ok());
  MapRequest along = ExactRequest();
  along.cut = whole->cut;
  ExpectExactMap(torus, along);
  along.options.seams = SeamKind::kRigid;
  ExpectExactMap(torus, along);
}

TEST(ExactMesh, NeedsNoVertexMovedWhereTheMapOnTheInputDoes) {
  const auto mesh = ReadSharedSurface("dir-cheburashka-subdivision");
  if (!mesh) GTEST_SKIP() << "the shared meshes are not there";
  const auto map = MapSurface(mesh->surface, ExactRequest());
  ASSERT_TRUE(map.ok());
  const Certificate& certificate = map->certificate;
  EXPECT_GT(*certificate.triangulation->moved_vertices, 0);
  EXPECT_LT(certificate.exact_map->exact_quasi_conformal_mean,
            certificate.distortion->quasi_conformal_mean);
  ExpectExactMap(mesh->surface, ExactRequest());
}

/// Where the exact map has each vertex, by the corners that it has as itself.
std::vector<Eigen::Vector2d> ExactPlaces(const Surface& surface, const ExactMap& exact) {
  std::vector<Eigen::Vector2d> place(surface.triangulation.num_vertices);
  for (std::size_t c = 0; c < exact.corner.size(); ++c) {
    if (exact.corner[c] < surface.triangulation.num_vertices) {
      place[exact.corner[c]] = exact.uv[exact.corner_uv[c]];
    }
  }
  return place;
}

TEST(ExactMesh, OfAPolygonHasItsSidesAndCornersByBothPatterns) {
  const Surface terrain = Stretched("bumpy_terrain", 600, 4);
  for (const char* domain : {"rectangle", "polygon", "triangle"}) {
    for (const PatternKind pattern : {PatternKind::kCircle, PatternKind::kEquivalence}) {
      MapRequest request = ExactRequest();
      request.domain = domain;
      request.options.pattern = pattern;
      ExpectExactMap(terrain, request);
      const auto map = MapSurface(terrain, request);
      ASSERT_TRUE(map.ok()) << map.status().message();
      const std::vector<Eigen::Vector2d> exact = ExactPlaces(terrain, *map->exact_map);
      const std::vector<Index> loop = BoundaryLoops(terrain.triangulation).front();
      for (const Index h : loop) {
        // Both maps have the boundary's vertices on the same sides; the places along them are those
        // of the metrics with and without refinement.
        const Index v = terrain.triangulation.Tail(h);
        const Eigen::Vector2d& plain = map->uv.value[Triangulation::Next(h)];
        EXPECT_LT((exact[v] - plain).norm(), 0.1) << domain;
        if (std::string(domain) != "rectangle") continue;
        const double modulus = *map->certificate.polygon->conformal_modulus;
        EXPECT_LT(std::min({exact[v].x(), exact[v].y(), 1 - exact[v].y(),
                            std::abs(modulus - exact[v].x())}),
                  0.05 * modulus);
        EXPECT_TRUE(exact[v].x() == 0 || exact[v].y() == 0 || exact[v].y() == 1 ||
                    std::abs(exact[v].x() - modulus) < 1e-6);
      }
    }
  }
}

TEST(ExactMesh, IsRefusedAboveItsLimit) {
  const Surface terrain = Stretched("bumpy_terrain", 600, 4);
  MapRequest small = ExactRequest();
  small.options.exact_limit = 100;
  EXPECT_THAT(MapSurface(terrain, small).status().message(), testing::HasSubstr("exact_limit"));
}

MapRequest ByEquivalence() {
  MapRequest request = ExactRequest();
  request.options.pattern = PatternKind::kEquivalence;
  request.options.strict = true;
  return request;
}

TEST(ExactMesh, OfConformalEquivalenceIsAValidMapToo) {
  ExpectExactMap(Stretched("bumpy_terrain", 600, 4), ByEquivalence());
  ExpectExactMap(Stretched("sphere", 500, 5), ByEquivalence());
  ExpectExactMap(Stretched("torus", 600, 4), ByEquivalence());
}

TEST(ExactMesh, OfAFlatSurfaceByConformalEquivalenceIsAnIsometry) {
  const Surface patch = Moved(GeneratedSurface("flat_delaunay_patch", 300), [](auto x) {
    return Eigen::Vector3d(x.x() + 0.5 * x.y(), x.y(), 0);
  });
  const auto map = MapSurface(patch, ByEquivalence());
  ASSERT_TRUE(map.ok()) << map.status().message();
  EXPECT_GT(map->certificate.triangulation->flips, 10);
  EXPECT_EQ(map->certificate.equivalence->ptolemy_flips, 0);
  EXPECT_NEAR(map->certificate.exact_map->exact_quasi_conformal_mean, 1, 1e-8);
  EXPECT_NEAR(map->certificate.exact_map->exact_log_area_ratio_l2, 0, 1e-8);
}

/// Of few triangles, vertices and boundary with cones that the input's triangles cannot have.
TEST(ExactMesh, IsThereWhereTheInputsTrianglesAreFlipped) {
  const Surface surface = Kleetope(GeneratedSurface("blob", 60));
  const Triangulation& t = surface.triangulation;
  ConeTargets targets = FreeBoundaryTargets(t);
  const Index wide = t.num_vertices - 1, last = t.num_vertices - 2;  // of three corners
  targets.lower[wide] = targets.upper[wide] = 3.5 * kPi;
  targets.lower[last] = targets.upper[last] = 3.25 * kPi;
  const double rest = (4 + 1.5 + 1.25) * kPi / 8;
  for (Index v = 0; v < 8; ++v) targets.lower[v] = targets.upper[v] = 2 * kPi - rest;
  MapRequest request;
  request.targets = targets;
  EXPECT_FALSE(MapSurface(surface, request).ok());
  request = ExactRequest();
  request.targets = targets;
  const auto map = MapSurface(surface, request);
  ASSERT_TRUE(map.ok()) << map.status().message();
  EXPECT_GT(map->certificate.layout->flipped_triangles, 0);
  EXPECT_FALSE(FlippedFaces(t, map->uv).empty());
  ASSERT_TRUE(map->certificate.ladder);
  EXPECT_EQ(map->certificate.ladder->tried.back().rung, "equivalence");
  ExpectExactMap(surface, request);
}

TEST(ExactMesh, OfASurfaceSolvedOnItsDoubleKeepsItsBoundary) {
  // A kite whose long boundary edges cannot stay (flatten_by_equivalence_test.cc), with more of them.
  const Surface rectangle =
      *SurfaceFromTriangles({{0, 0, 0}, {10, 0, 0}, {10, 1, 0}, {0, 1, 0}, {5, 0.5, 0}},
                            {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  MapRequest request = ByEquivalence();
  request.targets = FreeBoundaryTargets(rectangle.triangulation);
  request.targets->lower[4] = request.targets->upper[4] = 2.5 * kPi;
  const auto map = MapSurface(rectangle, request);
  ASSERT_TRUE(map.ok()) << map.status().message();
  EXPECT_EQ(map->certificate.equivalence->doubled, 1);
  ExpectExactMapIsAccepted(rectangle, *map);
}

}  // namespace
}  // namespace cirque

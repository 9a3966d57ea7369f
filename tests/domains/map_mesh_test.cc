#include "cirque/domains/map_mesh.h"

#include <cmath>
#include <memory>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/domains/map_arrays.h"
#include "cirque/generators/generators.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/verify/judge_map.h"
#include "cirque/verify/refinement_check.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::shared_ptr<const MeshParts> PartsOf(const PolygonSoup& soup, const std::string& repair) {
  auto parts = std::make_shared<MeshParts>();
  const Status status = TakeApart(soup, repair, parts.get());
  EXPECT_TRUE(status.ok()) << status.message();
  return parts;
}

PolygonSoup Terrain() { return *GenerateMesh("bumpy_terrain", {100, 1}); }
PolygonSoup Sphere() { return *GenerateMesh("sphere", {200, 1}); }

MappedMesh Mapped(const PolygonSoup& soup, const MeshOptions& options, const MapRequest& request) {
  return *MapMesh(PartsOf(soup, options.repair), options, [&](const Surface&) { return request; },
                  {});
}

TEST(MapMesh, OneComponentIsWhatMapSurfaceMakesOfIt) {
  const PolygonSoup soup = Terrain();
  const MappedMesh mapped = Mapped(soup, {}, {});
  ASSERT_TRUE(mapped.status.ok()) << mapped.status.message();
  EXPECT_EQ(mapped.map.uv.value, MapSurface(SurfaceOf(soup), MapRequest())->uv.value);
  EXPECT_TRUE(mapped.map.certificate.components.empty());
}

TEST(MapMesh, EveryFaceOfAnUncleanMeshComesBackAndTheJudgeAgrees) {
  const PolygonSoup soup = UncleanMesh();
  const auto map = MapSurface(ArraysOf(soup));
  ASSERT_TRUE(map.ok()) << map.status().message();
  EXPECT_EQ(map->mesh.corner, soup.corner);
  EXPECT_EQ(map->mesh.first_corner, soup.first_corner);
  ASSERT_TRUE(map->certificate.mesh_repair);
  EXPECT_EQ(map->certificate.mesh_repair->duplicate_faces.size(), 2u);
  EXPECT_EQ(map->certificate.mesh_repair->split_edges.size(), 1u);
  EXPECT_GE(map->certificate.components.size(), 2u);
  const auto verdict = JudgeMap(soup, map->mesh, {});
  ASSERT_TRUE(verdict.ok());
  EXPECT_TRUE(verdict->valid) << verdict->verdict;
}

/// Three polygons: triangles with a bridge between them, triangles that meet at a vertex, a triangle
/// with a spur; and a square whose other side of the bridge is left open.
TEST(MapMesh, LoopsOfAPolygonAreMappedEachForItself) {
  PolygonSoup soup;
  for (const auto& [x, y] : {std::pair(0, 0),
                             {-1, 1},
                             {-1, -1},
                             {2, 0},
                             {3, -1},
                             {3, 1},
                             {0, 2},
                             {1, 3},
                             {0, 3},
                             {0, -2},
                             {2, -2}}) {
    soup.position.emplace_back(x, y, 0);
  }
  for (const std::vector<std::int64_t>& face : {std::vector<std::int64_t>{0, 1, 2, 0, 3, 4, 5, 3},
                                                {6, 7, 8, 6, 1, 0},
                                                {0, 2, 9, 0, 10, 0},
                                                {0, 10, 4, 3}}) {
    ASSERT_EQ(AddPolygon(face, &soup), "");
  }
  const auto map = MapSurface(ArraysOf(soup));
  ASSERT_TRUE(map.ok()) << map.status().message();
  EXPECT_FALSE(map->certificate.mesh_repair && map->certificate.mesh_repair->num_set_aside() > 0);
  EXPECT_EQ(map->mesh.num_polygons(), 6);
  const auto verdict = JudgeMap(soup, map->mesh, {});
  ASSERT_TRUE(verdict.ok()) << verdict.status().message();
  EXPECT_TRUE(verdict->valid) << verdict->verdict;
}

/// A tube of six sides and `rings` rings, closed at one end, beside a triangle: the free boundary leaves
/// its far end e^rings times smaller than the near one.
PolygonSoup TubeBesideTriangle(Index rings) {
  PolygonSoup soup;
  const auto at = [](Index ring, Index i) { return 6 * ring + i % 6; };
  for (Index ring = 0; ring < rings; ++ring) {
    for (Index i = 0; i < 6; ++i) {
      const double angle = kPi / 3 * (static_cast<double>(i) + 0.5 * (ring % 2));
      soup.position.emplace_back(std::cos(angle), std::sin(angle), ring);
    }
  }
  const auto add = [&](const std::vector<std::int64_t>& corners) {
    EXPECT_EQ(AddPolygon(corners, &soup), "");
  };
  for (Index ring = 0; ring + 1 < rings; ++ring) {
    for (Index i = 0; i < 6; ++i) {
      const Index shift = ring % 2;
      add({at(ring, i), at(ring, i + 1), at(ring + 1, i + shift)});
      add({at(ring, i + 1), at(ring + 1, i + 1 + shift), at(ring + 1, i + shift)});
    }
  }
  const auto tip = static_cast<std::int64_t>(soup.position.size());
  soup.position.emplace_back(0, 0, rings);
  for (Index i = 0; i < 6; ++i) add({at(rings - 1, i), at(rings - 1, i + 1), tip});
  for (const double x : {0., 1., 2.}) soup.position.emplace_back(10 + x, x * x, 0);
  add({tip + 1, tip + 2, tip + 3});
  return soup;
}

TEST(MapMesh, AMapThatTheFrameHasNoDigitsForGetsCones) {
  const PolygonSoup soup = TubeBesideTriangle(50);
  const MappedMesh mapped = Mapped(soup, {}, {});
  ASSERT_TRUE(mapped.status.ok()) << mapped.status.message();
  const Certificate& tube = mapped.map.certificate.components.front();
  EXPECT_GT(tube.layout->cones.value_or(0), 0);
  EXPECT_TRUE(FlippedFaces(mapped.surface->triangulation, mapped.map.uv).empty());
  MapRequest strict;
  strict.options.strict = true;
  EXPECT_EQ(Mapped(soup, {}, strict).status.code(), StatusCode::kUnrepresentable);
}

TEST(MapMesh, WithoutRepairItIsRefusedAndSaysWhere) {
  MapOptions options;
  options.mesh.repair = "none";
  MapFailure failure;
  const Status status = MapSurface(ArraysOf(UncleanMesh()), options, {}, &failure).status();
  EXPECT_EQ(status.code(), StatusCode::kInvalidInput);
  EXPECT_FALSE(failure.preflight.non_manifold_edges.empty());
}

TEST(MapMesh, APreparedMeshIsRepairedAnewWhereAMapAsksForIt) {
  // Two unit squares whose common side has vertices twice.
  const std::vector<double> points = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0,
                                      1, 0, 0, 2, 0, 1, 2, 1, 1, 1, 1, 0};
  const std::vector<Index> corners = {0, 1, 2, 3, 4, 5, 6, 7}, first = {0, 4, 8};
  const auto mesh = PreparedMesh::Make({points, corners, first});
  ASSERT_TRUE(mesh.ok());
  EXPECT_EQ(mesh->num_components(), 2);
  MapOptions welded;
  welded.mesh.repair = "weld";
  const auto apart = mesh->Map({}), together = mesh->Map(welded);
  ASSERT_TRUE(apart.ok() && together.ok());
  EXPECT_EQ(apart->certificate.components.size(), 2u);
  EXPECT_TRUE(together->certificate.components.empty());
  EXPECT_EQ(together->UvOfCorner(1), together->UvOfCorner(4));
  EXPECT_NE(apart->UvOfCorner(1), apart->UvOfCorner(4));
}

TEST(MapMesh, WhatHasAMapIsThereWhereAnotherHasNone) {
  const PolygonSoup soup = Together({Terrain(), Sphere(), Terrain()});
  MapOptions to_disk;
  to_disk.domain = "disk";
  MapFailure failure;
  const Status status = MapSurface(ArraysOf(soup), to_disk, {}, &failure).status();
  EXPECT_EQ(status.code(), StatusCode::kInvalidInput);
  EXPECT_THAT(status.message(), HasSubstr("1 of 3 components without a map"));
  ASSERT_TRUE(failure.partial);
  EXPECT_EQ(failure.certificate.atlas->components_failed, 1);
  EXPECT_EQ(failure.partial->mesh.corner, soup.corner);
  const std::size_t of_sphere = 3 * static_cast<std::size_t>(Terrain().num_polygons());
  EXPECT_EQ(failure.partial->UvOfCorner(of_sphere), failure.partial->UvOfCorner(of_sphere + 1));
  EXPECT_NE(failure.partial->UvOfCorner(0), failure.partial->UvOfCorner(1));
}

TEST(MapMesh, ADomainOfOneComponentRefusesSeveral) {
  MapOptions to_sphere;
  to_sphere.domain = "sphere";
  const auto map = MapSurface(ArraysOf(Together({Sphere(), Sphere()})), to_sphere);
  EXPECT_EQ(map.status().code(), StatusCode::kInvalidInput);
  EXPECT_THAT(map.status().message(), HasSubstr("the mesh has 2 ("));
  EXPECT_TRUE(MapSurface(ArraysOf(Sphere()), to_sphere).ok());
}

TEST(MapMesh, ExactMapsOfSeveralComponentsLieSideBySideInTheFrame) {
  PolygonSoup sheared = Terrain();
  for (Eigen::Vector3d& p : sheared.position) p.x() += 1.3 * p.y();
  const PolygonSoup soup = Together({sheared, Sphere(), sheared});
  MapOptions options;
  options.exact = true;
  options.mesh.uv = "unit";
  const auto map = MapSurface(ArraysOf(soup), options);
  ASSERT_TRUE(map.ok()) << map.status().message();
  ASSERT_TRUE(map->exact);
  const ExactMesh& exact = *map->exact;
  ASSERT_TRUE(map->certificate.exact_map);
  EXPECT_EQ(map->certificate.exact_map->exact_triangles, exact.mesh.num_polygons());
  EXPECT_GT(exact.mesh.num_polygons(), soup.num_polygons() + 20);
  EXPECT_GT(map->certificate.exact_map->exact_faces_ratio, 1.05);
  const auto refinement = verify::CheckRefinement(soup, exact.mesh, exact.polygon);
  ASSERT_TRUE(refinement.ok());
  EXPECT_THAT(refinement->errors, ::testing::IsEmpty());
  PolygonSoup bare = exact.mesh;
  bare.texture.clear();
  bare.corner_texture.clear();
  const auto verdict = JudgeMap(bare, exact.mesh, {});
  ASSERT_TRUE(verdict.ok());
  EXPECT_TRUE(verdict->valid) << verdict->verdict;
  EXPECT_THAT(verdict->verdict, HasSubstr("injective"));
  EXPECT_THAT(verdict->verdict, HasSubstr("3 patches"));
  for (const Eigen::Vector2d& uv : exact.mesh.texture) {
    EXPECT_GE(uv.minCoeff(), 0);
    EXPECT_LE(uv.maxCoeff(), 1);
  }
}

TEST(MapMesh, ConesAndCutsFindTheirComponentByTheCallersNumbers) {
  const PolygonSoup terrain = Terrain(), soup = Together({terrain, Sphere()});
  const auto first = static_cast<Index>(terrain.position.size());
  MapOptions options;
  for (const Index v : {0, 4, 8, 19}) options.cones.push_back({first + v, kPi, kPi});
  const auto map = MapSurface(ArraysOf(soup), options);
  ASSERT_TRUE(map.ok()) << map.status().message();
  ASSERT_EQ(map->certificate.components.size(), 2u);
  EXPECT_EQ(map->certificate.components[1].layout->cones, 4);
  EXPECT_EQ(map->certificate.components[0].layout->cones.value_or(0), 0);
}

TEST(MapMesh, AProofNamesTheCallersVerticesAndFaces) {
  const PolygonSoup terrain = Terrain(), soup = Together({terrain, Sphere()});
  const auto first = static_cast<Index>(terrain.position.size());
  MapOptions options;
  options.options.strict = true;
  for (const Index v : {0, 4, 8, 19}) options.cones.push_back({first + v, 1.9 * kPi, 1.9 * kPi});
  MapFailure failure;
  const Status status = MapSurface(ArraysOf(soup), options, {}, &failure).status();
  ASSERT_EQ(status.code(), StatusCode::kInfeasible) << status.message();
  const InfeasibilityCertificate& proof = failure.certificate.infeasibility;
  ASSERT_FALSE(proof.empty());
  for (const Index v : proof.carrying_vertices) EXPECT_GE(v, first);
  for (const Index f : proof.carrying_faces) EXPECT_GE(f, terrain.num_polygons());
  EXPECT_FALSE(proof.carrying_vertices.empty() && proof.carrying_faces.empty());
  ASSERT_TRUE(failure.partial);
}

TEST(MapMesh, HolesAreFilledForTheSolveAlone) {
  const PolygonSoup annulus = *GenerateMesh("annulus", {200, 1});
  MeshOptions filling;
  filling.fill_holes = true;
  filling.uv = "unit";
  const MappedMesh mapped = Mapped(annulus, filling, {});
  ASSERT_TRUE(mapped.status.ok()) << mapped.status.message();
  EXPECT_EQ(mapped.num_filled_loops, 1);
  ASSERT_EQ(mapped.map.uv.value.size(), annulus.corner.size());
  double least = 1, greatest = 0;
  for (const Eigen::Vector2d& p : mapped.map.uv.value) {
    least = std::min(least, p.minCoeff());
    greatest = std::max(greatest, p.maxCoeff());
  }
  EXPECT_NEAR(least, filling.uv_margin, 1e-9);
  EXPECT_NEAR(greatest, 1 - filling.uv_margin, 1e-9);
}

TEST(MapMesh, ASurfaceOfOneSideAmongOthersIsNamed) {
  // A square, and a Moebius strip of five triangles.
  PolygonSoup soup;
  soup.position = {{0, 0, 9}, {1, 0, 9}, {1, 1, 9}, {0, 1, 9}};
  for (int i = 0; i < 5; ++i) {
    soup.position.emplace_back(std::cos(2 * kPi * i / 5), std::sin(2 * kPi * i / 5), 0.1 * i);
  }
  soup.corner = {0, 1, 2, 3};
  soup.first_corner = {0, 4};
  for (Index i = 0; i < 5; ++i) {
    soup.corner.insert(soup.corner.end(), {4 + i, 4 + (i + 1) % 5, 4 + (i + 2) % 5});
    soup.first_corner.push_back(static_cast<Index>(soup.corner.size()));
  }
  const auto parts = PartsOf(soup, "safe");
  ASSERT_EQ(parts->components.size(), 2u);
  EXPECT_EQ(parts->Surfaces().size(), 1u);
  EXPECT_THAT(parts->Sizes(), HasSubstr("2 (1 face from face 1 on, 5 faces from face 2 on)"));
  const MappedMesh mapped = Mapped(soup, {}, {});
  EXPECT_EQ(mapped.status.code(), StatusCode::kInvalidInput);
  EXPECT_THAT(mapped.status.message(), HasSubstr("5 faces from face 2 on"));
  ASSERT_TRUE(mapped.surface);
  EXPECT_EQ(mapped.surface->triangulation.num_faces(), 2);
}

}  // namespace
}  // namespace cirque

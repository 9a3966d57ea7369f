#include "cirque/remesh/remesh_surface.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/domains/domain.h"
#include "cirque/remesh/mesh_quality.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using testing::HasSubstr;

SurfaceMap MapOf(const Surface& surface) {
  MapRequest request;
  request.options.exact = true;
  request.options.refine_map = "none";
  StatusOr<SurfaceMap> map = MapSurface(surface, request);
  EXPECT_TRUE(map.ok()) << map.status().message();
  return map.ok() ? *std::move(map) : SurfaceMap();
}

RemeshedSurface Remeshed(const Surface& surface, const RemeshOptions& options) {
  const StatusOr<RemeshedSurface> made = RemeshSurface(surface, MapOf(surface), options);
  EXPECT_TRUE(made.ok()) << made.status().message();
  return made.ok() ? *made : RemeshedSurface();
}

bool IsSimplicial(const Triangulation& t) {
  std::set<std::pair<Index, Index>> seen;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (t.Tail(h) == t.Tip(h) || !seen.insert({t.Tail(h), t.Tip(h)}).second) return false;
  }
  return true;
}

class RemeshSurfaceTest : public testing::TestWithParam<const char*> {
 protected:
  Surface surface_ = GeneratedSurface(GetParam(), 1200);
};

TEST_P(RemeshSurfaceTest, KeepsTopologyAndLiesOnTheSurface) {
  RemeshOptions options;
  options.vertices = 400;
  const RemeshedSurface made = Remeshed(surface_, options);
  const Triangulation& t = made.triangulation;
  EXPECT_TRUE(IsSimplicial(t));
  EXPECT_EQ(EulerCharacteristic(t), EulerCharacteristic(surface_.triangulation));
  EXPECT_EQ(BoundaryLoops(t).size(), BoundaryLoops(surface_.triangulation).size());
  EXPECT_EQ(ConnectedPatches(t).count, 1);
  EXPECT_NEAR(t.num_vertices, 400, 20);
  const std::vector<bool> inner = BoundaryVertices(surface_.triangulation);
  for (std::size_t v = 0; v < made.point.size(); ++v) {
    const SurfacePoint& point = made.point[v];
    ASSERT_GE(point.face, 0);
    ASSERT_LT(point.face, surface_.triangulation.num_faces());
    EXPECT_GE(point.barycentric.minCoeff(), 0);
    EXPECT_NEAR(point.barycentric.sum(), 1, 1e-14);
    Eigen::Vector3d at(0, 0, 0);
    for (Index k = 0; k < 3; ++k)
      at += point.barycentric[k] *
            surface_.position[surface_.triangulation.vertex[3 * point.face + k]];
    EXPECT_LT((at - made.position[v]).norm(), 1e-12);
  }
}

TEST_P(RemeshSurfaceTest, MakesEvenTriangles) {
  RemeshOptions options;
  options.vertices = 600;
  const RemeshedSurface made = Remeshed(surface_, options);
  const MeshQuality quality = MeasureQuality(made.triangulation, made.position);
  EXPECT_GT(quality.mean_least_angle, 45);
  EXPECT_GT(quality.least_angle, 10);
  EXPECT_LT(quality.edge_deviation, 0.25);
  EXPECT_GT(quality.regular, 0.5);
  EXPECT_NEAR(quality.mean_edge / made.edge, 1, 0.15);
}

TEST_P(RemeshSurfaceTest, BoundaryVerticesLieOnTheBoundary) {
  RemeshOptions options;
  options.vertices = 300;
  const RemeshedSurface made = Remeshed(surface_, options);
  const Triangulation& old = surface_.triangulation;
  for (const auto& loop : BoundaryLoops(made.triangulation)) {
    for (const Index h : loop) {
      const SurfacePoint& point = made.point[made.triangulation.Tail(h)];
      double off = 1;
      for (Index k = 0; k < 3; ++k) {
        const bool is_outer = old.twin[3 * point.face + k] == kNone;
        const bool at_vertex = point.barycentric[k] > 1 - 1e-9;
        if (is_outer) off = std::min(off, point.barycentric[k]);
        if (at_vertex) off = 0;
      }
      EXPECT_LT(off, 1e-9);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, RemeshSurfaceTest,
                         testing::Values("bumpy_terrain", "spherical_cap", "annulus", "catenoid",
                                         "sphere", "blob", "torus", "double_torus"));

TEST(RemeshSurface, KeepsCornersAndFlatBoundaries) {
  const Surface strip = FlatStrip(6, 4);
  RemeshOptions options;
  options.edge = 0.4;
  const RemeshedSurface made = Remeshed(strip, options);
  const MeshQuality quality = MeasureQuality(made.triangulation, made.position);
  double area = 0;
  for (Index f = 0; f < made.triangulation.num_faces(); ++f) {
    const Index* v = &made.triangulation.vertex[3 * f];
    area += 0.5 * (made.position[v[1]] - made.position[v[0]])
                      .cross(made.position[v[2]] - made.position[v[0]])
                      .z();
  }
  EXPECT_NEAR(area, 24, 1e-10) << "the rectangle, all triangles of one orientation";
  EXPECT_GT(quality.least_angle, 25);
}

TEST(RemeshSurface, IsAsDenseAsAsked) {
  const Surface strip = FlatStrip(8, 4);
  RemeshOptions options;
  options.edge = 0.3;
  options.density.resize(strip.triangulation.num_vertices);
  for (Index v = 0; v < options.density.size(); ++v)
    options.density[v] = strip.position[v].x() < 3.5 ? 1 : strip.position[v].x() > 4.5 ? 4 : 2;
  const RemeshedSurface made = Remeshed(strip, options);
  int left = 0, right = 0;
  for (const Eigen::Vector3d& x : made.position) {
    left += x.x() < 3 ? 1 : 0;
    right += x.x() > 5 ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(right) / left, 4, 0.8);
}

TEST(RemeshSurface, MakesTheSimplestMeshesSimplicial) {
  for (const char* name : {"torus", "double_torus", "annulus", "sphere"}) {
    const Surface surface = GeneratedSurface(name, 400);
    RemeshOptions options;
    options.edge = 100;  // longer than any: what is left is what topology needs
    const RemeshedSurface made = Remeshed(surface, options);
    EXPECT_TRUE(IsSimplicial(made.triangulation)) << name;
    EXPECT_EQ(EulerCharacteristic(made.triangulation), EulerCharacteristic(surface.triangulation));
    EXPECT_LT(made.triangulation.num_vertices, surface.triangulation.num_vertices / 2) << name;
  }
}

TEST(RemeshSurface, GivesTheSameMeshTwice) {
  const Surface surface = GeneratedSurface("blob", 600);
  RemeshOptions options;
  options.vertices = 200;
  const RemeshedSurface a = Remeshed(surface, options), b = Remeshed(surface, options);
  EXPECT_EQ(a.triangulation.vertex, b.triangulation.vertex);
  EXPECT_EQ(a.position, b.position);
}

TEST(RemeshSurface, RefusesWhatMakesNoMesh) {
  const Surface strip = FlatStrip(4, 4);
  const SurfaceMap map = MapOf(strip);
  const auto expect = [&](const RemeshOptions& options, const char* word) {
    const StatusOr<RemeshedSurface> made = RemeshSurface(strip, map, options);
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.status().code(), StatusCode::kInvalidInput);
    EXPECT_THAT(made.status().message(), HasSubstr(word));
  };
  RemeshOptions options;
  expect(options, "one of");
  options.edge = 1e-5;
  expect(options, "at most");
  options.edge = 1;
  options.density = Eigen::VectorXd::Zero(strip.triangulation.num_vertices);
  expect(options, "positive");
  options.density.resize(3);
  expect(options, "densities");
  options = RemeshOptions();
  options.edge = 1;
  EXPECT_EQ(RemeshSurface(strip, SurfaceMap(), options).status().code(), StatusCode::kNotConverged);
}

}  // namespace
}  // namespace cirque

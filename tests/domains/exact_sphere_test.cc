// Exact maps to the sphere: judged by the independent judge, which must refuse what is planted.
#include "cirque/domains/exact_sphere.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/domains/exact_mesh.h"
#include "cirque/domains/map_arrays.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/verify/judge_map.h"

#include "tests/common/domain_maps.h"
#include "tests/common/exact_maps.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using Eigen::Vector3d;

MapRequest ExactRequest() {
  MapRequest request = RequestFor("sphere");
  request.options.exact = true;
  return request;
}

/// Long triangles, so that there is much to be flipped.
Surface Stretched(const std::string& generator, Index triangles, double by) {
  return Moved(GeneratedSurface(generator, triangles),
               [by](const Vector3d& x) { return Vector3d(x.x(), by * x.y(), x.z()); });
}

Vector3d CentreByArea(const Surface& surface, const std::vector<Vector3d>& place) {
  const std::vector<double> weight = VertexAreas(surface.triangulation, surface.position);
  Vector3d sum = Vector3d::Zero();
  for (std::size_t v = 0; v < weight.size(); ++v) sum += weight[v] * place[v];
  return sum;
}

TEST(ExactSphere, IsAcceptedByBothLayoutsRefinedOrNot) {
  const Surface surface = Stretched("blob", 600, 3);
  for (const char* refine : {"none", "auto"}) {
    for (const LayoutMethod layout : {LayoutMethod::kDirections, LayoutMethod::kLeastSquares}) {
      MapRequest request = ExactRequest();
      request.options.refine_map = refine;
      request.options.layout = layout;
      const SurfaceMap map = MustMap(surface, request);
      ASSERT_TRUE(map.exact_map);
      EXPECT_GT(map.certificate.exact_map->exact_crossings, 100);
      EXPECT_LT(map.certificate.exact_map->exact_layout_closure, 1e-8);
      ExpectExactMapIsAccepted(surface, map);
    }
  }
}

TEST(ExactSphere, IsNormalizedByItself) {
  const Surface surface = Stretched("blob", 500, 3);
  MapRequest request = ExactRequest();
  request.shape.principal_axes = true;
  const SurfaceMap map = MustMap(surface, request);
  ASSERT_TRUE(map.exact_map);
  const auto place = PlacesOfVertices(*map.exact_map, surface.triangulation.num_vertices);
  EXPECT_LT(CentreByArea(surface, place).norm(), 1e-12);
  // Both are turned to the same axes: what is left is the difference of the refinements.
  for (std::size_t v = 0; v < place.size(); ++v) {
    EXPECT_LT((place[v] - map.position[v]).norm(), 0.3);
  }
}

TEST(ExactSphere, OfWhatNeedsNoFlipIsTheMapAtTheVertices) {
  const Surface surface = RegularPolyhedron(20);
  const SurfaceMap map = MustMap(surface, ExactRequest());
  ASSERT_TRUE(map.exact_map);
  EXPECT_EQ(map.exact_map->num_triangles(), 20);
  EXPECT_EQ(PlacesOfVertices(*map.exact_map, 12), map.position);
  EXPECT_NEAR(map.certificate.exact_map->exact_quasi_conformal_max, 1, 1e-8);
  ExpectExactMapIsAccepted(surface, map);
}

// Kept vertices of three corners beside long edges: on the sphere the input's triangles are flipped.
TEST(ExactSphere, IsThereWhereTheInputsTrianglesAreFlipped) {
  const Surface surface = Kleetope(Stretched("blob", 60, 6));
  EXPECT_FALSE(MapSurface(surface, RequestFor("sphere")).ok());
  const SurfaceMap map = MustMap(surface, ExactRequest());
  ASSERT_TRUE(map.exact_map);
  ExpectExactMapIsAccepted(surface, map);
  EXPECT_EQ(map.certificate.layout->flipped_triangles,
            static_cast<int>(FlippedSphericalFaces(surface.triangulation, map.position).size()));
  EXPECT_GT(map.certificate.layout->flipped_triangles, 0);
  EXPECT_EQ(map.certificate.overlap, "unknown");
  EXPECT_TRUE(map.certificate.infeasibility.empty());
  EXPECT_GT(map.certificate.triangulation->flips, 0);  // of the solve that it is of
}

TEST(ExactSphere, TheJudgeRefusesPlantedErrors) {
  const Surface surface = Stretched("blob", 300, 3);
  const SurfaceMap map = MustMap(surface, ExactRequest());
  ASSERT_TRUE(map.exact_map);
  const ExactMesh exact = RefineByExactMap(TrianglesOf(surface), surface, *map.exact_map);
  const auto errors = [&](const std::vector<Vector3d>& sphere) {
    const auto verdict = JudgeSphereMap(exact.mesh, sphere);
    EXPECT_TRUE(verdict.ok());
    return verdict->verdict;
  };
  EXPECT_EQ(errors(exact.sphere), "valid (injective)");
  std::vector<Vector3d> moved = exact.sphere;
  moved.back() = -moved.back();
  EXPECT_THAT(errors(moved), testing::HasSubstr("flipped triangle"));
  moved = exact.sphere;
  moved.back() *= 1 + 1e-9;
  EXPECT_THAT(errors(moved), testing::HasSubstr("not on the unit sphere"));
  moved = exact.sphere;
  for (Vector3d& x : moved) x.z() = -x.z();
  EXPECT_THAT(errors(moved), testing::HasSubstr("flipped"));
}

TEST(ExactSphere, OfArraysHasAPointOfItForEveryVertex) {
  const PolygonSoup soup = TrianglesOf(Stretched("blob", 300, 3));
  MapOptions options;
  options.domain = "sphere";
  options.exact = true;
  const auto map = MapSurface(ArraysOf(soup), options);
  ASSERT_TRUE(map.ok()) << map.status().message();
  ASSERT_TRUE(map->exact);
  EXPECT_EQ(map->exact->sphere.size(), map->exact->mesh.position.size());
  EXPECT_GT(map->exact->sphere.size(), soup.position.size());
  EXPECT_TRUE(map->exact->mesh.texture.empty());
  for (const Vector3d& x : map->exact->sphere) EXPECT_NEAR(x.norm(), 1, 1e-15);
}

TEST(ExactSphere, AboveItsLimitIsRefused) {
  MapRequest request = ExactRequest();
  request.options.exact_limit = 100;
  request.options.strict = true;
  request.options.triangulation = SolvedTriangulation::kInput;
  const Certificate failed =
      MustFail(Stretched("sphere", 300, 1.2), request, StatusCode::kInvalidInput);
  EXPECT_THAT(failed.message, testing::HasSubstr("exact_limit"));
}

}  // namespace
}  // namespace cirque

#include "cirque/pipeline/flat_metric.h"

#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "cirque/pipeline/parameterize.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

PolygonSoup Soup(std::vector<Eigen::Vector3d> points,
                 const std::vector<std::vector<std::int64_t>>& polygons) {
  PolygonSoup soup;
  soup.position = std::move(points);
  for (const auto& polygon : polygons) EXPECT_EQ(AddPolygon(polygon, &soup), "");
  return soup;
}

/// A regular polygon of n corners, fanned from one of them: 2 (n - 2) angles of pi / n, and every
/// inner edge between two triangles on one circle; of another height a fan of needles, most of whose
/// edges a Delaunay triangulation has not.
Surface RegularPolygon(int n, double height = 1) {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::vector<std::int64_t>> triangles;
  for (int i = 0; i < n; ++i) {
    points.emplace_back(std::cos(2 * kPi * i / n), height * std::sin(2 * kPi * i / n), 0);
    if (i > 1) triangles.push_back({0, i - 1, i});
  }
  return SurfaceOf(Soup(points, triangles));
}

Surface Cube() {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 8; ++i) points.emplace_back(i & 1, (i >> 1) & 1, i >> 2);
  return SurfaceOf(
      Soup(points,
           {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}));
}

/// Its long diagonal is no edge of a Delaunay triangulation.
Surface Kite() {
  return SurfaceOf(Soup({{0, 0, 0}, {4, 1, 0}, {8, 0, 0}, {4, -1, 0}}, {{0, 2, 1}, {0, 3, 2}}));
}

std::optional<FlatMetric> FlatMetricOf(const Surface& surface, const ConeTargets& targets) {
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  return FlatMetricOf(MeasureSurface(surface.triangulation, lengths), targets);
}

std::optional<FlatMetric> FreeFlatMetricOf(const Surface& surface) {
  return FlatMetricOf(surface, FreeBoundaryTargets(surface.triangulation));
}

/// The largest difference of a length on the map from that on the surface.
double LengthError(const Surface& surface, const Parameterization& map) {
  const Triangulation& t = surface.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  double error = 0;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const double image =
        (map.uv.value[Triangulation::Next(h)] - map.uv.value[Triangulation::Prev(h)]).norm();
    error = std::max(error, std::abs(image - lengths.value[t.edge[h]]));
  }
  return error;
}

TEST(FlatMetric, OfAPolygonIsItsOwnCircumcircle) {
  const auto flat = FreeFlatMetricOf(RegularPolygon(1000));
  ASSERT_TRUE(flat);
  EXPECT_NEAR(flat->angles.value.minCoeff(), kPi / 1000, 1e-12);
  EXPECT_NEAR(flat->log_radii.value.cwiseAbs().maxCoeff(), 0, 1e-10);
}

TEST(FlatMetric, OfACubeNeedsConesAtItsCorners) {
  const Surface cube = Cube();
  ConeTargets targets = FreeBoundaryTargets(cube.triangulation);
  EXPECT_FALSE(FlatMetricOf(cube, targets));
  targets.lower.assign(8, 1.5 * kPi);
  targets.upper = targets.lower;
  const auto flat = FlatMetricOf(cube, targets);
  ASSERT_TRUE(flat);
  for (const double rho : flat->log_radii.value) EXPECT_NEAR(rho, std::log(std::sqrt(0.5)), 1e-15);
}

TEST(FlatMetric, IsNoneOfASurfaceThatIsAlmostFlat) {
  Surface strip = FlatStrip(6, 6);
  ASSERT_TRUE(FreeFlatMetricOf(strip));
  strip.position[24].z() = 1e-4;  // (3, 3): bends its angles by about 1e-8
  EXPECT_FALSE(FreeFlatMetricOf(strip));
}

TEST(FlatMetric, IsNoneWhereTheTriangulationIsNotDelaunay) {
  EXPECT_FALSE(FreeFlatMetricOf(Kite()));
}

TEST(FlatMetric, MapsOfFlatSurfacesAreTheSurfaces) {
  for (const Surface& surface :
       {RegularPolygon(1000), FlatStrip(6, 6), GeneratedSurface("flat_delaunay_patch", 500), Kite(),
        RegularPolygon(80, 1e-3)}) {
    Parameterization map;
    const Status status = Parameterize(surface, {}, {}, &map);
    ASSERT_TRUE(status.ok()) << status.message();
    EXPECT_LT(LengthError(surface, map), 1e-9);
    EXPECT_NEAR(map.certificate.distortion->quasi_conformal_max, 1, 1e-8);
    EXPECT_EQ(map.certificate.angle_fit->epsilon, 0);
    EXPECT_EQ(map.certificate.angle_fit->angle_iterations, 0);
    EXPECT_LE(map.certificate.radii->radii_gradient, 1e-12);
    EXPECT_LT(map.certificate.layout->layout_closure, 1e-10);
  }
}

TEST(FlatMetric, ConesOfAPolyhedronCanStillBeRefined) {
  const Surface cube = Cube();
  ParameterizeRequest request;
  request.targets = FreeBoundaryTargets(cube.triangulation);
  request.targets->lower.assign(8, 1.5 * kPi);
  request.targets->upper = request.targets->lower;
  request.options.refine_cones = 3;
  Parameterization map;
  const Status status = Parameterize(cube, request, {}, &map);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_LT(LengthError(cube, map), 1e-12);
}

}  // namespace
}  // namespace cirque

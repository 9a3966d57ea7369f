// The parts of a map to the sphere: poles, inversion, normalisation.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/domains/domain.h"
#include "cirque/domains/sphere_normalization.h"
#include "cirque/domains/sphere_pole.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using Eigen::Vector3d;
using ::testing::Contains;
using ::testing::HasSubstr;

IntrinsicTriangulation AsItIs(const Surface& surface) {
  return {surface.triangulation, MeasureEdgeLengths(surface), {}, {}};
}

TEST(PoleCandidates, AreDifferentVerticesWhateverTheScale) {
  const Surface blob = GeneratedSurface("blob", 500);
  const std::vector<Index> poles = PoleCandidates(blob, AsItIs(blob), 4);
  EXPECT_EQ(std::set<Index>(poles.begin(), poles.end()).size(), 4u);
  const Surface large =
      Moved(blob, [](const Vector3d& x) -> Vector3d { return 4096 * x; });  // exact
  EXPECT_EQ(PoleCandidates(large, AsItIs(large), 4), poles);
  EXPECT_EQ(PoleCandidates(blob, AsItIs(blob), 1), std::vector<Index>{poles[0]});
}

/// The surface of a box 1 x 1 x length, its squares cut in two.
Surface Box(int length) {
  std::vector<Vector3d> points;
  for (int k = 0; k <= length; ++k) {
    const double z = k;
    points.insert(points.end(), {Vector3d(0, 0, z), {1, 0, z}, {1, 1, z}, {0, 1, z}});
  }
  std::vector<std::array<Index, 3>> faces = {{0, 2, 1}, {0, 3, 2}};
  for (Index k = 0; k < 4 * length; k += 4) {
    for (Index i = 0; i < 4; ++i) {
      const Index a = k + i, b = k + (i + 1) % 4;
      faces.push_back({a, b, b + 4});
      faces.push_back({a, b + 4, a + 4});
    }
  }
  const Index top = 4 * length;
  faces.push_back({top, top + 1, top + 2});
  faces.push_back({top, top + 2, top + 3});
  return *SurfaceFromTriangles(points, faces);
}

TEST(PredictedLogRange, OfALimbIsItsLengthOverItsRadius) {
  // u falls by 2 pi over the circumference, 4, a unit of length; what the ends do does not grow.
  const Surface shorter = Box(50), longer = Box(100);
  const double grows = PredictedLogRange(AsItIs(longer), 0) - PredictedLogRange(AsItIs(shorter), 0);
  EXPECT_NEAR(grows, 50 * kPi / 2, 1e-6);
  EXPECT_NEAR(PredictedLogRange(AsItIs(shorter), 0), 50 * kPi / 2, 5);
}

TEST(MapToSphere, ALimbBeyondDoublesIsRefusedBeforeAnySolve) {
  MapRequest request;
  request.domain = "sphere";
  Certificate failed;
  const auto map = MapSurface(Box(600), request, {}, &failed);
  EXPECT_EQ(map.status().code(), StatusCode::kUnrepresentable);
  EXPECT_THAT(map.status().message(), HasSubstr("doubles cannot hold this surface on one sphere"));
  EXPECT_FALSE(failed.angle_fit.has_value());
  EXPECT_FALSE(failed.radii.has_value());
}

TEST(InvertedLengths, AreTheStereographicImageOfAnInscribedMesh) {
  const Surface sphere = GeneratedSurface("sphere", 200);
  const Triangulation& t = sphere.triangulation;
  const Index pole = 9;
  const auto punctured = Puncture(t, pole);
  ASSERT_TRUE(punctured.ok());
  const EdgeLengths inverted = InvertedLengths(sphere, t, MeasureEdgeLengths(sphere), *punctured);
  // From the pole the sphere is projected onto the plane through 0 orthogonal to it.
  const Vector3d n = sphere.position[pole].normalized();
  const auto projected = [&](Index v) -> Vector3d {
    const Vector3d x = sphere.position[punctured->vertex[v]];
    return n + (x - n) / (1 - n.dot(x));
  };
  const Triangulation& plane = punctured->triangulation;
  std::vector<double> ratio;
  for (Index e = 0; e < plane.num_edges(); ++e) {
    const Index h = plane.edge_halfedge[e];
    ratio.push_back(inverted.value[e] /
                    (projected(plane.Tip(h)) - projected(plane.Tail(h))).norm());
  }
  const auto [least, greatest] = std::minmax_element(ratio.begin(), ratio.end());
  EXPECT_GT(*least, 0);
  EXPECT_NEAR(*greatest / *least, 1, 1e-9);
}

TEST(SphericalDelaunayMargin, IsThatOfRegularPolyhedra) {
  // The link of the pole is a regular polygon with as many corners as faces meet at a vertex: where
  // its sides, which are circles through the pole, cross, they turn by 2 pi / corners; all other
  // pairs of neighbouring circles cross alike.
  for (const auto& [faces, corners] : {std::pair(4, 3), std::pair(8, 4), std::pair(20, 5)}) {
    const Surface polyhedron = RegularPolyhedron(faces);
    const auto punctured = Puncture(polyhedron.triangulation, 0);
    ASSERT_TRUE(punctured.ok());
    const EdgeLengths lengths = InvertedLengths(polyhedron, polyhedron.triangulation,
                                                MeasureEdgeLengths(polyhedron), *punctured);
    const IntrinsicSurface plane = MeasureSurface(punctured->triangulation, lengths);
    EXPECT_NEAR(SphericalDelaunayMargin(plane, plane.angles.value), 2 * kPi / corners, 1e-9)
        << faces;
  }
}

TEST(NumberAsInFile, NamesWhatTheSurfaceHas) {
  const Surface octahedron = RegularPolyhedron(8);
  const auto punctured = Puncture(octahedron.triangulation, 2);
  ASSERT_TRUE(punctured.ok());
  InfeasibilityCertificate proof;
  for (Index f = 0; f < 4; ++f) proof.face_multiplier.push_back(f + 1);
  proof.carrying_faces = {3};
  proof.constrained_vertex = {0, 1};
  proof.carrying_vertices = {1};
  NumberAsInFile(octahedron, *punctured, &proof);
  EXPECT_EQ(proof.removed_vertex, octahedron.soup_vertex[2]);
  ASSERT_EQ(proof.face_multiplier.size(), 8u);
  EXPECT_EQ(std::accumulate(proof.face_multiplier.begin(), proof.face_multiplier.end(), 0.), 10);
  EXPECT_EQ(proof.face_multiplier[proof.carrying_faces[0]], 4);
  EXPECT_EQ(proof.carrying_vertices[0], octahedron.soup_vertex[punctured->vertex[1]]);
  EXPECT_NE(proof.constrained_vertex[0], proof.removed_vertex);
}

/// Vertices of a regular polyhedron projected from the last one's opposite: a plane with a pole.
PlaneWithPole Projected(const Surface& surface, Index pole, double scale) {
  const Vector3d n = surface.position[pole].normalized();
  const Vector3d x = n.unitOrthogonal(), y = n.cross(x);
  PlaneWithPole plane;
  plane.pole = pole;
  for (const Vector3d& p : surface.position) {
    const double height = 1 - n.dot(p);
    plane.position.emplace_back(height > 1e-9 ? scale * Eigen::Vector2d(x.dot(p), y.dot(p)) / height
                                              : Eigen::Vector2d(0, 0));
  }
  return plane;
}

TEST(NormalizeChart, UniformMassesOfARegularPolyhedronAreCentredAtAnyScale) {
  const Surface icosahedron = RegularPolyhedron(20);
  for (const double scale : {1e-6, 1., 1e6}) {
    const PlaneWithPole plane = Projected(icosahedron, 0, scale);
    const auto chart = NormalizeChart(icosahedron, plane, "uniform");
    ASSERT_TRUE(chart.ok()) << chart.status().message();
    EXPECT_LE(chart->residual, 1e-12);
    const std::vector<Vector3d> points = LiftAll(plane, chart->chart);
    Vector3d mass = Vector3d::Zero();
    for (const Vector3d& p : points) {
      EXPECT_NEAR(p.norm(), 1, 1e-14);
      mass += p / 12;
    }
    EXPECT_LT(mass.norm(), 1e-12) << scale;
    // All edges are equal again.
    double shortest = 2, longest = 0;
    const Triangulation& t = icosahedron.triangulation;
    for (const Index h : t.edge_halfedge) {
      const double length = (points[t.Tip(h)] - points[t.Tail(h)]).norm();
      shortest = std::min(shortest, length);
      longest = std::max(longest, length);
    }
    EXPECT_NEAR(longest / shortest, 1, 1e-9) << scale;
  }
}

TEST(NormalizeChart, EveryNameIsKnownAndOthersAreNot) {
  const Surface octahedron = RegularPolyhedron(8);
  const PlaneWithPole plane = Projected(octahedron, 0, 1);
  EXPECT_THAT(SphereNormalizations(), Contains("least_area_distortion"));
  for (const std::string& name : SphereNormalizations()) {
    const auto chart = NormalizeChart(octahedron, plane, name);
    ASSERT_TRUE(chart.ok()) << name << ": " << chart.status().message();
    EXPECT_NEAR(std::accumulate(chart->weights.begin(), chart->weights.end(), 0.), 1, 1e-12);
  }
  const auto unknown = NormalizeChart(octahedron, plane, "surfaces_area");
  EXPECT_EQ(unknown.status().code(), StatusCode::kInvalidInput);
  EXPECT_THAT(unknown.status().message(), HasSubstr("surface_area"));
}

TEST(VertexAreas, AreSharesOfTheAreaInvariantUnderScale) {
  const Surface blob = GeneratedSurface("blob", 200);
  const std::vector<double> area = VertexAreas(blob.triangulation, blob.position);
  EXPECT_NEAR(std::accumulate(area.begin(), area.end(), 0.), 1, 1e-12);
  EXPECT_GT(*std::min_element(area.begin(), area.end()), 0);
  const Surface large = Moved(blob, [](const Vector3d& x) -> Vector3d { return 16 * x; });
  EXPECT_EQ(VertexAreas(large.triangulation, large.position), area);
  // Every vertex of a regular polyhedron has the same share.
  const Surface icosahedron = RegularPolyhedron(20);
  for (const double share : VertexAreas(icosahedron.triangulation, icosahedron.position)) {
    EXPECT_NEAR(share, 1. / 12, 1e-12);
  }
}

TEST(PrincipalAxes, AreThoseOfABoxOfPoints) {
  const double x = 0.9, y = 0.4, z = 0.1;
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(2.1, Vector3d(1, -1, 2).normalized()).toRotationMatrix();
  std::vector<Vector3d> points;
  std::vector<double> weights;
  for (const Vector3d& p : {Vector3d(x, 0, 0), Vector3d(-x, 0, 0), Vector3d(0, y, 0),
                            Vector3d(0, -y, 0), Vector3d(0, 0, z), Vector3d(0, 0, -z)}) {
    points.push_back(turn * p);
    weights.push_back(1. / 6);
  }
  // A little more on one side of the two longer axes decides the signs.
  weights[0] += 0.01;
  weights[2] += 0.01;
  const Eigen::Matrix3d axes = PrincipalAxes(points, weights);
  EXPECT_NEAR(axes.determinant(), 1, 1e-12);
  EXPECT_LT((axes * axes.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
  EXPECT_LT((axes * points[0] - Vector3d(x, 0, 0)).norm(), 1e-3);
  EXPECT_LT((axes * points[2] - Vector3d(0, y, 0)).norm(), 1e-3);
}

}  // namespace
}  // namespace cirque

// What every registered domain promises, by a loop over the registry.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/domains/domain.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/metrics/measure_map.h"
#include "cirque/pipeline/certificate.h"

#include "tests/common/domain_maps.h"
#include "tests/common/exact_maps.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using Eigen::Vector3d;
using ::testing::HasSubstr;

/// A surface of the domain's own topology.
Surface SurfaceFor(const std::string& domain, Index triangles) {
  return GeneratedSurface(GeneratorFor(domain), triangles);
}

/// Where the vertices lie: a point of the plane or of the sphere, of the plane in its first two
/// coordinates.
std::vector<Vector3d> Points(const Surface& surface, const SurfaceMap& map) {
  if (map.IsOnSphere()) return map.position;
  std::vector<Vector3d> points(surface.position.size());
  for (Index h = 0; h < surface.triangulation.num_halfedges(); ++h) {
    const Eigen::Vector2d& uv = map.uv.value[h];
    points[surface.triangulation.vertex[h]] = {uv.x(), uv.y(), 0};
  }
  return points;
}

/// Largest difference of the distances of pairs in a sample, over the largest distance in it.
double Incongruence(const std::vector<Vector3d>& a, const std::vector<Vector3d>& b) {
  double difference = 0, largest = 0;
  const std::size_t step = 1 + a.size() / 50;
  for (std::size_t i = 0; i < a.size(); i += step) {
    for (std::size_t j = 0; j < i; j += step) {
      const double before = (a[i] - a[j]).norm(), after = (b[i] - b[j]).norm();
      difference = std::max(difference, std::abs(before - after));
      largest = std::max(largest, before);
    }
  }
  return difference / largest;
}

/// The same surface with vertex v as number order[v], its faces in reverse.
Surface Renumbered(const Surface& surface, const std::vector<Index>& order) {
  PolygonSoup soup;
  soup.position.resize(surface.position.size());
  for (std::size_t v = 0; v < order.size(); ++v) soup.position[order[v]] = surface.position[v];
  const Triangulation& t = surface.triangulation;
  for (Index f = t.num_faces() - 1; f >= 0; --f) {
    for (const Index k : {1, 2, 0}) soup.corner.push_back(order[t.vertex[3 * f + k]]);
    soup.first_corner.push_back(static_cast<Index>(soup.corner.size()));
  }
  return SurfaceOf(soup);
}

class EveryDomain : public ::testing::TestWithParam<std::string> {
 protected:
  const std::string domain_ = GetParam();
  const Domain entry_ = *Domains().Find(domain_);
};

TEST_P(EveryDomain, MapsWithoutFlipsAndGivesWhatItSays) {
  const Surface surface = SurfaceFor(domain_, 300);
  const Triangulation& t = surface.triangulation;
  const SurfaceMap map = MustMap(surface, RequestFor(domain_));
  EXPECT_EQ(map.certificate.outcome, "ok");
  EXPECT_EQ(map.certificate.overlap, "injective");
  EXPECT_EQ(map.certificate.layout->flipped_triangles, 0);
  EXPECT_EQ(entry_.Gives("position"), map.IsOnSphere());
  EXPECT_EQ(entry_.Gives("uv"), !map.uv.value.empty());
  if (map.IsOnSphere()) {
    EXPECT_TRUE(FlippedSphericalFaces(t, map.position).empty());
  } else {
    EXPECT_TRUE(FlippedFaces(t, map.uv).empty());
  }
  if (entry_.Gives("flat")) {
    EXPECT_EQ(map.flat.on_input.lengths.value.size(), t.num_edges());
  }
  EXPECT_GE(*map.certificate.seconds.total, *map.certificate.seconds.radii);
  EXPECT_FALSE(entry_.help.empty());
}

TEST_P(EveryDomain, HasAnExactMapWhereItTakesOne) {
  const Surface surface = Moved(SurfaceFor(domain_, 400), [](const Vector3d& x) {
    return Vector3d(x.x(), 2 * x.y() + 0.5 * x.x(), x.z());
  });
  MapRequest request = RequestFor(domain_);
  request.options.exact = true;
  if (!entry_.Reads("exact")) {
    const Certificate failed = MustFail(surface, request, StatusCode::kInvalidInput);
    EXPECT_THAT(failed.message, HasSubstr("takes no exact"));
    return;
  }
  const SurfaceMap map = MustMap(surface, request);
  ASSERT_TRUE(map.exact_map);
  EXPECT_GT(map.certificate.exact_map->exact_crossings, 10);
  EXPECT_GE(map.certificate.exact_map->exact_quasi_conformal_mean, 1);
  ExpectExactMapIsAccepted(surface, map);
}

TEST_P(EveryDomain, NeitherScaleNorPlaceOfTheSurfaceMatter) {
  const Surface surface = SurfaceFor(domain_, 300);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Vector3d(1, 2, -0.5).normalized()).toRotationMatrix();
  const Surface moved = Moved(
      surface, [&](const Vector3d& x) { return Vector3d(30 * (turn * x) + Vector3d(1, -2, 3)); });
  std::vector<Vector3d> before = Points(surface, MustMap(surface, RequestFor(domain_)));
  std::vector<Vector3d> after = Points(moved, MustMap(moved, RequestFor(domain_)));
  // The image in the plane keeps the surface's area; the other domains have a size of their own.
  if (domain_ == "plane") {
    for (Vector3d& x : after) x /= 30;
  }
  EXPECT_LT(Incongruence(before, after), 1e-7);
}

TEST_P(EveryDomain, NumbersOfVerticesAndFacesDoNotMatter) {
  const Surface surface = SurfaceFor(domain_, 200);
  std::vector<Index> order(surface.position.size());
  std::iota(order.begin(), order.end(), 0);
  std::rotate(order.begin(), order.begin() + 17, order.end());
  std::reverse(order.begin() + 40, order.end());
  const Surface renumbered = Renumbered(surface, order);
  std::vector<Index> now(order.size());  // the renumbered surface's vertex of every vertex
  for (std::size_t v = 0; v < order.size(); ++v) {
    const auto& numbers = renumbered.soup_vertex;
    now[v] =
        static_cast<Index>(std::find(numbers.begin(), numbers.end(), order[v]) - numbers.begin());
  }
  // Corners that are not given are sought from the first boundary vertex on: they do depend on it.
  MapRequest before_request = RequestFor(domain_), after_request = before_request;
  if (entry_.Reads("corners")) {
    const std::vector<Index> loop = BoundaryLoops(surface.triangulation).front();
    const std::size_t sides = domain_ == "triangle" ? 3 : 4;
    for (std::size_t k = 0; k < sides; ++k) {
      const Index corner = surface.triangulation.Tail(loop[k * loop.size() / sides]);
      before_request.shape.corners.push_back(corner);
      after_request.shape.corners.push_back(now[corner]);
    }
  }
  // The hemisphere's boundary turns alike everywhere: where the curve begins is rounding's to say.
  if (entry_.Reads("curve")) {
    const Index start = surface.triangulation.Tail(BoundaryLoops(surface.triangulation)[0][0]);
    before_request.shape.angle_zero = start;
    after_request.shape.angle_zero = now[start];
  }
  const SurfaceMap map = MustMap(surface, before_request);
  const SurfaceMap of_renumbered = MustMap(renumbered, after_request);
  for (const auto& [name, value] : NumbersOf(map.certificate)) {
    if (name.find("modulus") == std::string::npos) continue;
    EXPECT_NEAR(NumbersOf(of_renumbered.certificate).at(name), value, 1e-5) << name;
  }
  if (!map.cut.IsEmpty()) return;  // a vertex on the cut has several places
  const std::vector<Vector3d> before = Points(surface, map);
  const std::vector<Vector3d> found = Points(renumbered, of_renumbered);
  std::vector<Vector3d> after;
  for (const Index v : now) after.push_back(found[v]);
  EXPECT_LT(Incongruence(before, after), 1e-6);
}

TEST_P(EveryDomain, RefusesSurfacesAndRequestsThatDoNotFit) {
  const Surface surface = SurfaceFor(domain_, 100);
  const auto refusal = [&](const Surface& refused, const MapRequest& request) {
    return MustFail(refused, request, StatusCode::kInvalidInput).message;
  };
  if (domain_ != "plane") {
    for (const char* other : {"hemisphere", "annulus", "blob", "torus"}) {
      const bool is_ring = std::string(other) == "annulus";
      if (other == GeneratorFor(domain_) || (is_ring && domain_ == "round_holes")) continue;
      EXPECT_FALSE(refusal(GeneratedSurface(other, 200), RequestFor(domain_)).empty()) << other;
    }
  }
  MapRequest request = RequestFor(domain_);
  request.options.radii_solver = "newtn";
  EXPECT_THAT(refusal(surface, request), HasSubstr("did you mean 'newton'?"));
  request = RequestFor(domain_);
  request.shape.pole = surface.triangulation.num_vertices;
  EXPECT_THAT(refusal(surface, request), HasSubstr("is no vertex"));
  request = RequestFor(domain_);
  request.cut = Cut{std::vector<bool>(surface.triangulation.num_edges(), false)};
  if (!entry_.Reads("cut")) {
    EXPECT_THAT(refusal(surface, request), HasSubstr("takes no cut"));
  }
  request = RequestFor(domain_);
  request.targets = FreeBoundaryTargets(surface.triangulation);
  if (!entry_.Reads("targets")) {
    EXPECT_THAT(refusal(surface, request), HasSubstr("takes no targets"));
  }
  request = RequestFor(domain_);
  request.options.refine_map = "symmetric_dirichlet";
  if (!entry_.Reads("boundary") && entry_.Reads("refine_map")) {
    EXPECT_THAT(refusal(surface, request), HasSubstr("take the plane, or another refine_map"));
  }
}

TEST_P(EveryDomain, AProofGoesWithWhatIsInfeasible) {
  const Surface surface = Kleetope(SurfaceFor(domain_, 60));
  MapRequest request = RequestFor(domain_);
  request.options.triangulation = SolvedTriangulation::kInput;
  const Certificate failed = MustFail(surface, request, StatusCode::kInfeasible);
  EXPECT_EQ(static_cast<Index>(failed.infeasibility.face_multiplier.size()),
            surface.triangulation.num_faces());
  EXPECT_GT(failed.infeasibility.margin, 0);
  EXPECT_FALSE(failed.distortion.has_value());
  // On intrinsic Delaunay connectivity the same surface has a map.
  request.options.triangulation = SolvedTriangulation::kDelaunay;
  EXPECT_TRUE(MapSurface(surface, request).ok());
}

TEST_P(EveryDomain, TooFewStepsAreNoMap) {
  MapRequest request = RequestFor(domain_);
  request.options.radii_solver = "ceres_line_search";
  request.options.max_iterations = 1;
  request.options.strict = true;  // a surface can be unfolded without a step
  const Certificate failed = MustFail(SurfaceFor(domain_, 200), request, StatusCode::kNotConverged);
  EXPECT_FALSE(failed.distortion.has_value());
  EXPECT_TRUE(failed.infeasibility.empty());
}

TEST_P(EveryDomain, ACancelledSolveIsNoMap) {
  const std::atomic<bool> cancelled = true;
  Certificate failed;
  const auto map =
      MapSurface(SurfaceFor(domain_, 200), RequestFor(domain_), {{}, &cancelled}, &failed);
  EXPECT_EQ(map.status().code(), StatusCode::kCancelled);
  EXPECT_EQ(failed.outcome, "cancelled");
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryDomain, testing::ValuesIn(Domains().Names()),
                         [](const auto& domain) { return domain.param; });

/// A limb too long for its image: coordinates differ by more than doubles hold.
TEST(MapSurface, WhatDoublesCannotHoldIsSaid) {
  const Certificate failed =
      MustFail(FlatStrip(240, 4), RequestFor("half_plane"), StatusCode::kUnrepresentable);
  EXPECT_TRUE(failed.infeasibility.empty());
  EXPECT_TRUE(failed.radii.has_value());  // the pattern there is
}

TEST(MapSurface, UnknownDomainsAreRefused) {
  const Certificate failed = MustFail(Fan(5, 0.3), RequestFor("disc"), StatusCode::kInvalidInput);
  EXPECT_THAT(failed.message, HasSubstr("did you mean 'disk'"));
  EXPECT_TRUE(NumbersOf(failed).empty());
}

TEST(Domains, EveryOptionOfAShapeIsReadBySomeDomain) {
  for (const char* option : {"centre", "angle_zero", "pole", "normalization", "corners", "sides",
                             "principal_axes", "inversion", "targets", "cut", "curve"}) {
    EXPECT_TRUE(IsReadBySomeDomain(option)) << option;
  }
  EXPECT_FALSE(IsReadBySomeDomain("io"));
}

TEST(MapSurface, SurfacesOfExtremeSizeAreMappedAsTheyAreAtSizeOne) {
  const Surface terrain = GeneratedSurface("bumpy_terrain", 300);
  const StatusOr<SurfaceMap> map = MapSurface(terrain, {});
  ASSERT_TRUE(map.ok());
  EXPECT_TRUE(FlippedFaces(terrain.triangulation, map->uv).empty());
  for (const int exponent : {-900, -530, 530, 900}) {
    Surface scaled = terrain;
    for (Eigen::Vector3d& x : scaled.position) x *= std::ldexp(1.0, exponent);
    const StatusOr<SurfaceMap> of_scaled = MapSurface(scaled, {});
    ASSERT_TRUE(of_scaled.ok()) << exponent << of_scaled.status().message();
    for (std::size_t c = 0; c < map->uv.value.size(); ++c) {
      EXPECT_EQ(of_scaled->uv.value[c], map->uv.value[c] * std::ldexp(1.0, exponent));
    }
    const StatusOr<SurfaceMap> on_disk = MapSurface(scaled, RequestFor("disk"));
    ASSERT_TRUE(on_disk.ok()) << exponent << on_disk.status().message();
    for (const Eigen::Vector2d& uv : on_disk->uv.value) EXPECT_LE(uv.norm(), 1 + 1e-12);
  }
}

}  // namespace
}  // namespace cirque

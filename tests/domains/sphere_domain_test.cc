#include <cmath>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/domains/built_in_domains.h"
#include "cirque/domains/sphere_normalization.h"
#include "cirque/layout/moebius_normalization.h"
#include "cirque/metrics/injectivity.h"

#include "tests/common/domain_maps.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using Eigen::Vector3d;
using ::testing::HasSubstr;

SurfaceMap Map(const Surface& surface, const DomainOptions& shape = {},
               const ParameterizeOptions& options = {}) {
  return MustMap(surface, RequestFor("sphere", shape, options));
}

/// Small margins, so that Delaunay triangles of a sphere are coherent as they are.
ParameterizeOptions Exact() {
  ParameterizeOptions options;
  options.epsilon = 1e-8;
  return options;
}

/// Largest difference of the distances of all pairs in a sample.
double Incongruence(const std::vector<Vector3d>& a, const std::vector<Vector3d>& b) {
  double largest = 0;
  const std::size_t step = 1 + a.size() / 60;
  for (std::size_t i = 0; i < a.size(); i += step) {
    for (std::size_t j = 0; j < i; j += step) {
      largest = std::max(largest, std::abs((a[i] - a[j]).norm() - (b[i] - b[j]).norm()));
    }
  }
  return largest;
}

Vector3d CentreOfMass(const std::vector<Vector3d>& points, const std::vector<double>& weights) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t v = 0; v < points.size(); ++v) sum += weights[v] * points[v];
  return sum;
}

/// Spheroids of revolution are mapped by their latitude alone: log tan of half the image's polar
/// angle is the integral of ds / radius along the meridian, here by Simpson's rule.
Vector3d OfSpheroid(const Vector3d& x, double c) {
  const double radius = std::hypot(x.x(), x.y());
  const double end = std::atan2(radius, x.z() / c);
  if (radius == 0) return {0, 0, x.z() > 0 ? 1. : -1.};
  const auto slope = [c](double t) {
    return std::hypot(std::cos(t), c * std::sin(t)) / std::sin(t);
  };
  constexpr int kSteps = 2000;
  const double step = (end - kPi / 2) / kSteps;
  double integral = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double t = kPi / 2 + i * step;
    integral += step / 6 * (slope(t) + 4 * slope(t + step / 2) + slope(t + step));
  }
  const double polar = 2 * std::atan(std::exp(integral));
  return {std::sin(polar) * x.x() / radius, std::sin(polar) * x.y() / radius, std::cos(polar)};
}

TEST(SphereDomain, RegularPolyhedraStayRegular) {
  for (const int faces : {4, 8, 20}) {
    const Surface polyhedron = RegularPolyhedron(faces);
    ASSERT_EQ(polyhedron.triangulation.num_faces(), faces);
    for (const Index pole : {0, 3}) {
      const SurfaceMap map = Map(polyhedron, {.pole = pole, .normalization = "uniform"});
      EXPECT_LT(Incongruence(map.position, polyhedron.position), 1e-12) << faces;
      EXPECT_NEAR(map.certificate.distortion->quasi_conformal_max, 1, 1e-12);
    }
  }
}

TEST(SphereDomain, AnInscribedDelaunayMeshIsItsOwnMapWhateverThePole) {
  const Surface sphere = GeneratedSurface("sphere", 800);
  const std::vector<double> equal(sphere.position.size(), 1);
  // Normalised by the same condition, two maps of one circle pattern differ by a rotation.
  const LorentzNormalization centred = MinimizeLorentz(sphere.position, equal);
  for (const Index pole : {kNone, 7, 200}) {
    const SurfaceMap map = Map(sphere, {.pole = pole, .normalization = "uniform"}, Exact());
    EXPECT_LT(Incongruence(map.position, centred.points), 1e-7) << pole;
  }
}

TEST(SphereDomain, SpheroidsConvergeToTheirConformalMap) {
  constexpr double kLength = 2;
  std::vector<double> error;
  for (const Index triangles : {500, 8000}) {
    const Surface spheroid = Moved(GeneratedSurface("sphere", triangles), [](const Vector3d& x) {
      return Vector3d(x.x(), x.y(), kLength * x.z());
    });
    std::vector<Vector3d> known;
    for (const Vector3d& x : spheroid.position) known.push_back(OfSpheroid(x, kLength));
    error.push_back(Incongruence(Map(spheroid).position, known));
  }
  EXPECT_LT(error[0], 0.08);
  EXPECT_LT(error[1], 0.45 * error[0]);
}

TEST(SphereDomain, EveryNormalizationKeepsItsPromise) {
  const Surface blob = GeneratedSurface("blob", 1000);
  for (const std::string& name : SphereNormalizations()) {
    const SurfaceMap map = Map(blob, {.normalization = name});
    for (const Vector3d& x : map.position) EXPECT_NEAR(x.norm(), 1, 1e-15);
    EXPECT_TRUE(FlippedSphericalFaces(blob.triangulation, map.position).empty()) << name;
    EXPECT_NEAR(SphericalDegree(blob.triangulation, map.position), 1, 1e-12);
    const std::map<std::string, std::vector<double>> weights = {
        {"uniform", std::vector<double>(map.position.size(), 1. / map.position.size())},
        {"surface_area", VertexAreas(blob.triangulation, blob.position)},
        {"image_area", VertexAreas(blob.triangulation, map.position)}};
    if (weights.count(name) == 0) continue;
    EXPECT_LT(CentreOfMass(map.position, weights.at(name)).norm(), 1e-12) << name;
  }
}

TEST(SphereDomain, TheLeastAreaDistortionIsTheLeast) {
  const Surface blob = GeneratedSurface("blob", 1000);
  const auto l2 = [&](const char* name) {
    return Map(blob, {.pole = 11, .normalization = name}).certificate.distortion->log_area_ratio_l2;
  };
  const double least = l2("least_area_distortion");
  for (const char* name : {"none", "uniform", "surface_area", "image_area"}) {
    EXPECT_LT(least, l2(name) + 1e-3) << name;
  }
}

TEST(SphereDomain, DistortionDependsLittleOnThePole) {
  const Surface blob = GeneratedSurface("blob", 2000);
  const double chosen = Map(blob).certificate.distortion->quasi_conformal_mean;
  EXPECT_LT(chosen, 1.1);
  for (const Index pole : {1, 100, 500}) {
    const SurfaceMap map = Map(blob, {.pole = pole});
    EXPECT_EQ(map.certificate.sphere->pole_vertex, pole);
    EXPECT_NEAR(map.certificate.distortion->quasi_conformal_mean, chosen, 0.002) << pole;
  }
}

TEST(SphereDomain, TheCirclesAtThePoleIntersectProperlyToo) {
  const Surface blob = GeneratedSurface("blob", 600);
  ParameterizeOptions options;
  options.epsilon = 0.02;
  const SurfaceMap map = Map(blob, {.pole = 40}, options);
  EXPECT_GE(*map.certificate.sphere->delaunay_margin, 0.02 - 1e-9);
}

TEST(SphereDomain, PrincipalAxesUndoARotationOfTheSurface) {
  const Surface blob = GeneratedSurface("blob", 500);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  const Surface turned = Moved(blob, [&](const Vector3d& x) { return Vector3d(turn * x); });
  const SurfaceMap a = Map(blob, {.pole = 3, .principal_axes = true});
  const SurfaceMap b = Map(turned, {.pole = 3, .principal_axes = true});
  for (std::size_t v = 0; v < a.position.size(); ++v) {
    EXPECT_LT((a.position[v] - b.position[v]).norm(), 1e-7);
  }
}

TEST(SphereDomain, TheInversionAboutThePoleLowersTheDistortion) {
  const Surface blob = GeneratedSurface("blob", 600);
  const auto distortion = [&](bool inversion) {
    DomainOptions options{.pole = 40};
    options.inversion = inversion;
    ParameterizeOptions unrefined;
    unrefined.refine_map = "none";
    return Map(blob, options, unrefined).certificate.distortion->quasi_conformal_mean;
  };
  EXPECT_GT(distortion(true), 1);
  EXPECT_LT(distortion(true), distortion(false) - 0.005);
}

TEST(SphereDomain, EntropyDistortsLessThanTheQuadraticProgram) {
  const Surface blob = GeneratedSurface("blob", 600);
  const auto distortion = [&](const char* objective) {
    ParameterizeOptions options;
    options.angle_objective = objective;
    return Map(blob, {}, options).certificate.distortion->quasi_conformal_mean;
  };
  EXPECT_LT(distortion("entropy"), distortion("quadratic"));
}

TEST(SphereDomain, AProofNamesTheVertexThatWasRemoved) {
  const Surface kleetope = Kleetope(GeneratedSurface("sphere", 100));
  ParameterizeOptions on_input;
  on_input.triangulation = SolvedTriangulation::kInput;
  const InfeasibilityCertificate proof =
      MustFail(kleetope, RequestFor("sphere", {.pole = 5}, on_input), StatusCode::kInfeasible)
          .infeasibility;
  EXPECT_EQ(proof.removed_vertex, 5);
  ASSERT_EQ(static_cast<Index>(proof.face_multiplier.size()), kleetope.triangulation.num_faces());
  for (Index h = 0; h < kleetope.triangulation.num_halfedges(); ++h) {
    if (kleetope.triangulation.vertex[h] == 5) {
      EXPECT_EQ(proof.face_multiplier[h / 3], 0);
    }
  }
  // Flipped to intrinsic Delaunay it has a map.
  EXPECT_EQ(Map(kleetope, {.pole = 5}).certificate.sphere->pole_vertex, 5);
}

TEST(SphereDomain, RefusesWhatIsNoSphere) {
  const auto refusal = [](const Surface& surface, const DomainOptions& shape) {
    return MustFail(surface, RequestFor("sphere", shape), StatusCode::kInvalidInput).message;
  };
  EXPECT_THAT(refusal(GeneratedSurface("torus", 500), {}), HasSubstr("genus 1"));
  EXPECT_THAT(refusal(GeneratedSurface("annulus", 500), {}), HasSubstr("boundary loops: 2"));
  const Surface sphere = GeneratedSurface("sphere", 100);
  EXPECT_THAT(refusal(sphere, {.pole = 1000}), HasSubstr("no vertex"));
  EXPECT_THAT(refusal(sphere, {.normalization = "unifrom"}), HasSubstr("did you mean 'uniform'"));
}

TEST(SphereDomain, ACancelledSolveLeavesNoMap) {
  const std::atomic<bool> cancelled = true;
  const auto map =
      MapSurface(GeneratedSurface("blob", 400), RequestFor("sphere"), {{}, &cancelled});
  EXPECT_EQ(map.status().code(), StatusCode::kCancelled);
}

}  // namespace
}  // namespace cirque

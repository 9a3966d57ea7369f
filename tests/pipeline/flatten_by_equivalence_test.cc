// Maps by discrete conformal equivalence: by themselves, beside the circle pattern's, and as the last
// rung of the ladder.
#include "cirque/pipeline/flatten_by_equivalence.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/mesh/preflight.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/parameterize.h"
#include "cirque/radii/solve_log_radii.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using testing::HasSubstr;

ParameterizeOptions ByEquivalence() {
  ParameterizeOptions options;
  options.pattern = PatternKind::kEquivalence;
  options.strict = true;
  return options;
}

TEST(FlattenByEquivalence, MapsSurfacesOfEveryTopology) {
  for (const char* generator : {"bumpy_terrain", "catenoid", "blob", "torus", "double_torus"}) {
    const Surface surface = GeneratedSurface(generator, 400);
    Parameterization map;
    const Status status = Parameterize(surface, {ByEquivalence()}, {}, &map);
    ASSERT_TRUE(status.ok()) << generator << ": " << status.message();
    EXPECT_TRUE(FlippedFaces(surface.triangulation, map.uv).empty()) << generator;
    EXPECT_EQ(map.certificate.outcome, "ok");
    ASSERT_TRUE(map.certificate.equivalence.has_value());
    EXPECT_FALSE(map.certificate.angle_fit.has_value());
    EXPECT_FALSE(map.certificate.radii.has_value());
    const EquivalenceSummary& scales = *map.certificate.equivalence;
    EXPECT_LE(scales.scales_residual, 1e-10);
    EXPECT_GT(scales.scales_iterations, 0);
    EXPECT_GT(scales.log_scale_range, 0);
    EXPECT_EQ(scales.gradients.size(), static_cast<std::size_t>(scales.scales_iterations) + 1);
    EXPECT_GT(*map.certificate.seconds.scales, 0);
  }
}

TEST(FlattenByEquivalence, IsNearlyAsConformalAsTheCirclePattern) {
  const Surface surface = GeneratedSurface("bumpy_terrain", 2000);
  ParameterizeOptions circle;
  circle.refine_map = "none";
  ParameterizeOptions equivalence = ByEquivalence();
  equivalence.refine_map = "none";
  Parameterization by_circle, by_equivalence;
  ASSERT_TRUE(Parameterize(surface, {circle}, {}, &by_circle).ok());
  ASSERT_TRUE(Parameterize(surface, {equivalence}, {}, &by_equivalence).ok());
  const double distortion = by_circle.certificate.distortion->quasi_conformal_mean - 1;
  EXPECT_NEAR(by_equivalence.certificate.distortion->quasi_conformal_mean - 1, distortion,
              0.1 * distortion);
  EXPECT_NE(by_equivalence.certificate.distortion->quasi_conformal_mean - 1, distortion);
}

TEST(FlattenByEquivalence, TheFlatMetricIsACirclePatternOfTheSurfacesArea) {
  const Surface surface = GeneratedSurface("blob", 500);
  Parameterization map;
  ASSERT_TRUE(Parameterize(surface, {ByEquivalence()}, {}, &map).ok());
  const Triangulation& t = map.flat.intrinsic.triangulation;
  double least_theta = kPi;
  for (const Index h : t.edge_halfedge) {
    least_theta =
        std::min(least_theta, kPi - map.flat.angles.value[h] - map.flat.angles.value[t.twin[h]]);
  }
  EXPECT_GT(least_theta, -1e-10);
  const CornerAngles angles = FlatCornerAngles(t, map.flat.angles, map.flat.log_radii);
  EXPECT_LT((angles.value - map.flat.angles.value).lpNorm<Eigen::Infinity>(), 1e-6);
  const EdgeLengths lengths = FlatEdgeLengths(t, angles, map.flat.log_radii);
  const Eigen::VectorXd ratio =
      lengths.value.cwiseQuotient(map.flat.intrinsic_lengths.value).array() - 1;
  EXPECT_LT(ratio.lpNorm<Eigen::Infinity>(), 1e-5);
  const auto area = [](const Triangulation& of, const Eigen::VectorXd& length,
                       const Eigen::VectorXd& angle) {
    double sum = 0;
    for (Index f = 0; f < of.num_faces(); ++f) {
      sum += 0.5 * length[of.edge[3 * f]] * length[of.edge[3 * f + 1]] * std::sin(angle[3 * f + 2]);
    }
    return sum;
  };
  const double flat = area(t, map.flat.intrinsic_lengths.value, map.flat.angles.value);
  const double source =
      area(surface.triangulation, MeasureEdgeLengths(surface).value, AnglesOf(surface).value);
  EXPECT_NEAR(flat / source, 1, 1e-12);
}

TEST(FlattenByEquivalence, ABoundaryThatCannotStayIsSolvedOnTheDouble) {
  // The middle of a long rectangle is to have 5/2 pi: with the long sides in place, two angles of pi
  // and degenerate triangles.
  const Surface rectangle =
      *SurfaceFromTriangles({{0, 0, 0}, {10, 0, 0}, {10, 1, 0}, {0, 1, 0}, {5, 0.5, 0}},
                            {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  const Triangulation& t = rectangle.triangulation;
  ConeTargets targets = FreeBoundaryTargets(t);
  targets.lower[4] = targets.upper[4] = 2.5 * kPi;
  const EdgeLengths lengths = MeasureEdgeLengths(rectangle);
  const IntrinsicSurface surface = MeasureSurface(t, lengths);
  const ParameterizeOptions options = ByEquivalence();
  const SolveControl control;
  Certificate certificate;
  FlatSurface flat;
  const Status status =
      FlattenByEquivalence({surface, targets, options, control}, &certificate, &flat);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_EQ(certificate.equivalence->doubled, 1);
  EXPECT_LE(certificate.equivalence->scales_residual, 1e-10);
  EXPECT_NEAR(VertexAngleSums(t, flat.on_input.angles)[4], 2.5 * kPi, 1e-10);
  EXPECT_GT(flat.on_input.angles.value.minCoeff(), 0);
  // Symmetric as the rectangle is.
  EXPECT_NEAR(flat.on_input.angles.value[2], flat.on_input.angles.value[8], 1e-10);
  EXPECT_NEAR(flat.on_input.angles.value[5], flat.on_input.angles.value[11], 1e-10);
}

TEST(FlattenByEquivalence, SaysWhatGaussBonnetForbids) {
  const Surface sphere = RegularPolyhedron(20);
  Parameterization map;
  const Status status =
      Parameterize(sphere, {ByEquivalence(), FreeBoundaryTargets(sphere.triangulation)}, {}, &map);
  EXPECT_EQ(status.code(), StatusCode::kInfeasible);
  EXPECT_THAT(status.message(), HasSubstr("Gauss-Bonnet"));
  const EdgeLengths lengths = MeasureEdgeLengths(sphere);
  const IntrinsicSurface surface = MeasureSurface(sphere.triangulation, lengths);
  EXPECT_FALSE(HasEquivalentMetric(surface, FreeBoundaryTargets(sphere.triangulation)));
  const std::vector<double> regular(12, 5 * kPi / 3);
  EXPECT_TRUE(HasEquivalentMetric(surface, {regular, regular}));
}

TEST(FlattenByEquivalence, OptionsOfTheCirclePatternAreRefused) {
  ParameterizeOptions options = ByEquivalence();
  options.triangulation = SolvedTriangulation::kInput;
  EXPECT_THAT(CheckOptions(options).message(), HasSubstr("flips edges"));
  options = ByEquivalence();
  options.refine_cones = 2;
  EXPECT_THAT(CheckOptions(options).message(), HasSubstr("needs pattern = circle"));
}

/// A triangle split twice, in spires: innermost vertices of three corners leave no coherent angles,
/// and no flip in the surface's metric helps.
Surface WithoutCoherentAngles() {
  return Moved(Kleetope(Kleetope(FlatStrip(1, 1))),
               [](const Eigen::Vector3d& x) -> Eigen::Vector3d {
                 const bool on_square = x.x() == 0 || x.y() == 0 || x.x() == 1 || x.y() == 1;
                 const Eigen::Vector3d a(1. / 3, 1. / 3, 0), b(2. / 3, 1. / 3, 0),
                     c(1. / 3, 2. / 3, 0), d(2. / 3, 2. / 3, 0);
                 double nearest = 1;
                 for (const Eigen::Vector3d& p : {a, b, c, d})
                   nearest = std::min(nearest, (x - p).norm());
                 return on_square || nearest < 1e-9 ? x : x + Eigen::Vector3d(0, 0, 2);
               });
}

TEST(FlattenByEquivalence, IsTheLastRungForTargetsThatNoCirclePatternHas) {
  const Surface surface = WithoutCoherentAngles();
  const ConeTargets targets = FreeBoundaryTargets(surface.triangulation);
  Parameterization strict, map;
  ParameterizeOptions options;
  options.strict = true;
  EXPECT_EQ(Parameterize(surface, {options, targets}, {}, &strict).code(), StatusCode::kInfeasible);
  options.strict = false;
  const Status status = Parameterize(surface, {options, targets}, {}, &map);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_EQ(map.targets.lower, targets.lower);
  EXPECT_TRUE(FlippedFaces(surface.triangulation, map.uv).empty());
  EXPECT_EQ(map.certificate.ladder->tried.back().rung, "equivalence");
  EXPECT_THAT(map.certificate.ladder->made_with, HasSubstr("conformal equivalence"));
}

}  // namespace
}  // namespace cirque

#include <gtest/gtest.h>

#include "cirque/angles/infeasibility.h"
#include "cirque/angles/registry.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

struct Fitted {
  Status status;
  AngleFitResult result;
};

Fitted Fit(const Surface& surface, const ConeTargets& targets, double epsilon = 1e-3) {
  const AngleConstraints constraints(surface.triangulation, targets);
  const CornerAngles reference = AnglesOf(surface);
  Fitted fitted;
  fitted.status =
      FitAngles({constraints, reference.value, epsilon}, *AngleObjectives().Find("quadratic"),
                **MakeAngleSolver("newton"), {}, &fitted.result);
  return fitted;
}

TEST(AngleFit, SymmetricFanSplitsTheFullAngleEvenly) {
  const Surface fan = Fan(5, 0.8);
  const Fitted fitted = Fit(fan, FreeBoundaryTargets(fan.triangulation));
  ASSERT_TRUE(fitted.status.ok()) << fitted.status.message();
  for (Index h = 0; h < fan.triangulation.num_halfedges(); ++h) {
    const double expected = fan.triangulation.vertex[h] == 0 ? 2 * kPi / 5 : 3 * kPi / 10;
    EXPECT_NEAR(fitted.result.angles.value[h], expected, 1e-12);
  }
}

TEST(AngleFit, LeavesAFlatDelaunayPatchAlone) {
  const Surface patch = GeneratedSurface("flat_delaunay_patch", 400);
  const Fitted fitted = Fit(patch, FreeBoundaryTargets(patch.triangulation), 1e-9);
  ASSERT_TRUE(fitted.status.ok());
  EXPECT_LT((fitted.result.angles.value - AnglesOf(patch).value).lpNorm<Eigen::Infinity>(), 1e-8);
}

TEST(AngleFit, IsFeasibleAndHasNoDualityGap) {
  for (const char* name : {"bumpy_terrain", "spherical_cap", "enneper_patch", "capped_tube"}) {
    SCOPED_TRACE(name);
    const Surface surface = GeneratedSurface(name, 800);
    const Fitted fitted = Fit(surface, FreeBoundaryTargets(surface.triangulation));
    ASSERT_TRUE(fitted.status.ok()) << fitted.status.message();
    const KktReport& kkt = fitted.result.kkt;
    EXPECT_LT(kkt.triangle_sum_residual, 1e-14);
    EXPECT_LT(kkt.vertex_sum_residual, 1e-10);
    EXPECT_GE(kkt.smallest_angle, 1e-3 - 1e-11);
    EXPECT_GE(kkt.smallest_theta, 1e-3 - 1e-11);
    EXPECT_LT(kkt.RelativeGap(), 1e-9);
    EXPECT_GT(kkt.primal, 1e-3);
    EXPECT_LE(fitted.result.solve.factorizations, 12);
  }
}

TEST(AngleFit, FixedBoundaryAnglesAreMet) {
  const Surface fan = Fan(6, 0.5);
  ConeTargets targets = FreeBoundaryTargets(fan.triangulation);
  // A hexagon whose corners alternate between 100 and 140 degrees.
  const double sharp = 5 * kPi / 9, blunt = 7 * kPi / 9;
  for (Index v = 1; v <= 6; ++v) targets.lower[v] = targets.upper[v] = v % 2 ? sharp : blunt;
  const Fitted fitted = Fit(fan, targets);
  ASSERT_TRUE(fitted.status.ok()) << fitted.status.message();
  const AngleConstraints constraints(fan.triangulation, targets);
  const Eigen::VectorXd sums = constraints.Apply(fitted.result.angles.value);
  EXPECT_NEAR(sums[6 + 1], sharp, 1e-11);
  EXPECT_NEAR(sums[6 + 2], blunt, 1e-11);
}

TEST(AngleFit, AnglesOnTheEdgeOfDelaunayAreCertifiedImpossible) {
  // A regular triangle from a hexagonal fan: the edges to its corners see two right angles.
  const Surface fan = Fan(6, 0.5);
  ConeTargets targets = FreeBoundaryTargets(fan.triangulation);
  for (Index v = 1; v <= 6; ++v) targets.lower[v] = targets.upper[v] = v % 2 ? kPi / 3 : kPi;
  const Fitted fitted = Fit(fan, targets);
  EXPECT_EQ(fitted.status.code(), StatusCode::kInfeasible);
  EXPECT_EQ(fitted.result.infeasibility.epsilon_over_pi, 0);
}

TEST(AngleFit, MarginShrinksWhereValenceForcesIt) {
  const Surface fan = Fan(40, 0.1);
  const Fitted fitted = Fit(fan, FreeBoundaryTargets(fan.triangulation), 0.12);
  ASSERT_TRUE(fitted.status.ok()) << fitted.status.message();
  EXPECT_LT(fitted.result.angles.epsilon, 0.12);
  EXPECT_GE(fitted.result.kkt.smallest_angle, fitted.result.angles.epsilon - 1e-12);
}

TEST(AngleFit, CertifiesThatAKleetopeHasNoCoherentAngles) {
  const Surface kleetope = Kleetope(GeneratedSurface("bumpy_terrain", 200));
  const Fitted fitted = Fit(kleetope, FreeBoundaryTargets(kleetope.triangulation));
  EXPECT_EQ(fitted.status.code(), StatusCode::kInfeasible);
  EXPECT_EQ(fitted.result.infeasibility.epsilon_over_pi, 0);
  EXPECT_GT(fitted.result.infeasibility.margin, 0);
  EXPECT_FALSE(fitted.result.infeasibility.carrying_faces.empty());
}

TEST(AngleFit, AnImpossibleConeIsCertifiedImpossible) {
  // Two triangles' worth of corners cannot make 2 pi: each is below pi.
  const Surface fan = Fan(6, 0.5);
  ConeTargets targets = FreeBoundaryTargets(fan.triangulation);
  targets.lower[1] = targets.upper[1] = 2 * kPi;
  EXPECT_EQ(Fit(fan, targets).status.code(), StatusCode::kInfeasible);
}

TEST(Infeasibility, MarginOfMultipliersThatCertifyNothingIsNotPositive) {
  const Surface surface = GeneratedSurface("bumpy_terrain", 200);
  const ConeTargets targets = FreeBoundaryTargets(surface.triangulation);
  const AngleConstraints constraints(surface.triangulation, targets);
  for (int i = 0; i < 20; ++i) {
    const Eigen::VectorXd y = Eigen::VectorXd::Random(constraints.num_rows());
    EXPECT_LT(InfeasibilityMargin(constraints, 1e-3, y), 0);
    EXPECT_TRUE(FindInfeasibilityCertificate(constraints, 1e-3, y).empty());
  }
}

}  // namespace
}  // namespace cirque

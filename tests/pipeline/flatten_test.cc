#include "cirque/pipeline/flatten.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/pipeline/parameterize.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

/// A surface with what its flattening needs, which refers to it.
struct Case {
  explicit Case(Surface of) : surface(std::move(of)), lengths(MeasureEdgeLengths(surface)) {}
  Case(const Case&) = delete;

  IntrinsicSurface Measured() const { return MeasureSurface(surface.triangulation, lengths); }

  Surface surface;
  EdgeLengths lengths;
};

FlatSurface MustFlatten(const Case& c, const ConeTargets& targets, Certificate* certificate,
                        const ParameterizeOptions& options = {},
                        const std::vector<bool>* locked = nullptr) {
  FlatSurface flat;
  const Status status = Flatten({c.Measured(), targets, options, {}, locked}, certificate, &flat);
  EXPECT_TRUE(status.ok()) << status.message();
  return flat;
}

double HeronArea(double a, double b, double c) {
  const double s = 0.5 * (a + b + c);
  return std::sqrt(s * (s - a) * (s - b) * (s - c));
}

double Area(const Triangulation& t, const EdgeLengths& lengths) {
  double area = 0;
  for (Index h = 0; h < t.num_halfedges(); h += 3) {
    area += HeronArea(lengths.value[t.edge[h]], lengths.value[t.edge[h + 1]],
                      lengths.value[t.edge[h + 2]]);
  }
  return area;
}

TEST(Flatten, WhereTheDualHasWanderedTheInputsOwnTrianglesAreFittedFirst) {
  const Case c(GeneratedSurface("bumpy_terrain", 600));
  const ConeTargets targets = *DefaultTargets(c.surface);
  const IntrinsicSurface surface = c.Measured();
  for (const bool wandered : {false, true}) {
    FlatSurface flat;
    Certificate certificate;
    const DualFit dual = wandered ? DualFit::kWandered : DualFit::kFirst;
    const FlattenJob job = {surface, targets, {}, {}, nullptr, nullptr, dual};
    ASSERT_TRUE(Flatten(job, &certificate, &flat).ok());
    EXPECT_EQ(flat.intrinsic.flips.empty(), wandered);
    EXPECT_EQ(certificate.angle_fit->solver == "interior_point", wandered);
    EXPECT_TRUE(flat.on_input.flipped.empty());
  }
}

// One step is not enough for the dual; the interior point has steps of its own.
TEST(Flatten, TheInteriorPointDecidesOnlyWhereAMapIsWantedAnyway) {
  const Case c(GeneratedSurface("bumpy_terrain", 600));
  const ConeTargets targets = *DefaultTargets(c.surface);
  const IntrinsicSurface surface = c.Measured();
  ParameterizeOptions options;
  options.max_iterations = 1;
  for (const DualFit dual : {DualFit::kFirst, DualFit::kOrNothing}) {
    FlatSurface flat;
    Certificate certificate;
    const Status status =
        Flatten({surface, targets, options, {}, nullptr, nullptr, dual}, &certificate, &flat);
    const bool decided = certificate.angle_fit->solver == "interior_point";
    EXPECT_EQ(decided, dual == DualFit::kFirst) << status.message();
    EXPECT_EQ(certificate.angle_fit->vertex_sum_residual < 1e-10, decided);
    EXPECT_TRUE(decided || status.code() == StatusCode::kNotConverged) << status.message();
  }
}

TEST(Flatten, TheFlatMetricObeysGaussBonnetAndItsTargets) {
  for (const char* name : {"bumpy_terrain", "blob", "torus", "double_torus", "annulus"}) {
    SCOPED_TRACE(name);
    const Case c(GeneratedSurface(name, 600));
    const ConeTargets targets = *DefaultTargets(c.surface);
    Certificate certificate;
    const FlatSurface flat = MustFlatten(c, targets, &certificate);
    const Triangulation& t = c.surface.triangulation;
    const std::vector<double> sum = VertexAngleSums(t, flat.on_input.angles);
    const std::vector<bool> boundary = BoundaryVertices(t);
    double curvature = 0, cones = 0;
    for (Index v = 0; v < t.num_vertices; ++v) {
      curvature += (boundary[v] ? kPi : 2 * kPi) - sum[v];
      EXPECT_GE(sum[v], targets.lower[v] - 1e-7);
      EXPECT_LE(sum[v], targets.upper[v] + 1e-7);
      if (!boundary[v]) cones += std::abs(2 * kPi - sum[v]) > 1e-6 ? 1 : 0;
    }
    EXPECT_NEAR(curvature, 2 * kPi * EulerCharacteristic(t), 1e-7);
    // Only a closed surface that is no torus needs cones.
    const bool needs_cones = BoundaryLoops(t).empty() && EulerCharacteristic(t) != 0;
    EXPECT_EQ(cones > 0, needs_cones);
    EXPECT_NEAR(Area(t, flat.on_input.lengths) / Area(t, c.lengths), 1, 1e-9);
  }
}

TEST(Flatten, ThePatternIsDelaunayWhereItWasSolved) {
  const Case c(GeneratedSurface("bumpy_terrain", 800));
  Certificate certificate;
  const FlatSurface flat =
      MustFlatten(c, FreeBoundaryTargets(c.surface.triangulation), &certificate);
  const Triangulation& t = flat.intrinsic.triangulation;
  const CornerAngles angles = MeasureCornerAngles(t, flat.intrinsic_lengths);
  double smallest_theta = kPi;
  for (const Index h : t.edge_halfedge) {
    if (t.twin[h] == kNone) continue;
    const double theta = kPi - angles.value[h] - angles.value[t.twin[h]];
    smallest_theta = std::min(smallest_theta, theta);
    // Circles intersect in the angles that the fit chose.
    EXPECT_NEAR(theta, kPi - flat.angles.value[h] - flat.angles.value[t.twin[h]], 1e-7);
  }
  EXPECT_GE(smallest_theta, certificate.angle_fit->epsilon - 1e-9);
  EXPECT_EQ(certificate.triangulation->flips, static_cast<int>(flat.intrinsic.flips.size()));
  EXPECT_GT(certificate.triangulation->flips, 0);
}

TEST(Flatten, ScaleOfTheSurfaceIsScaleOfTheMetric) {
  const Case one(GeneratedSurface("spherical_cap", 400));
  const Case large(Moved(one.surface, [](const Eigen::Vector3d& x) -> Eigen::Vector3d {
    return 1024 * x;  // exact
  }));
  Certificate unused;
  const ConeTargets targets = FreeBoundaryTargets(one.surface.triangulation);
  const FlatSurface a = MustFlatten(one, targets, &unused),
                    b = MustFlatten(large, targets, &unused);
  EXPECT_EQ(a.angles.value, b.angles.value);
  EXPECT_EQ(a.intrinsic.flips, b.intrinsic.flips);
  const Eigen::VectorXd ratio = b.on_input.lengths.value.cwiseQuotient(a.on_input.lengths.value);
  EXPECT_NEAR(ratio.minCoeff(), 1024, 1e-9);
  EXPECT_NEAR(ratio.maxCoeff(), 1024, 1e-9);
}

TEST(Flatten, AFlatSurfaceIsItsOwnFlatMetric) {
  const Case c(GeneratedSurface("flat_delaunay_patch", 500));
  ParameterizeOptions options;
  options.epsilon = 1e-9;
  Certificate certificate;
  const FlatSurface flat =
      MustFlatten(c, FreeBoundaryTargets(c.surface.triangulation), &certificate, options);
  const Eigen::VectorXd ratio = flat.on_input.lengths.value.cwiseQuotient(c.lengths.value);
  EXPECT_NEAR(ratio.minCoeff(), 1, 1e-6);
  EXPECT_NEAR(ratio.maxCoeff(), 1, 1e-6);
}

TEST(Flatten, LockedEdgesStay) {
  const Case c(GeneratedSurface("bumpy_terrain", 400));
  const ConeTargets targets = FreeBoundaryTargets(c.surface.triangulation);
  Certificate certificate;
  MustFlatten(c, targets, &certificate);
  ASSERT_GT(certificate.triangulation->flips, 0);
  const std::vector<bool> all(c.surface.triangulation.num_edges(), true);
  ParameterizeOptions options;
  options.epsilon = 1e-4;
  const FlatSurface flat = MustFlatten(c, targets, &certificate, options, &all);
  EXPECT_EQ(certificate.triangulation->flips, 0);
  EXPECT_EQ(flat.intrinsic.triangulation.vertex, c.surface.triangulation.vertex);
}

TEST(Flatten, TheReasonWhyThereIsNoneComesWithTheResult) {
  const Case c(Kleetope(GeneratedSurface("bumpy_terrain", 100)));
  ParameterizeOptions options;
  options.triangulation = SolvedTriangulation::kInput;
  const ConeTargets targets = FreeBoundaryTargets(c.surface.triangulation);
  Certificate certificate;
  FlatSurface flat;
  const Status status = Flatten({c.Measured(), targets, options, {}}, &certificate, &flat);
  EXPECT_EQ(status.code(), StatusCode::kInfeasible);
  EXPECT_GT(flat.infeasibility.margin, 0);
  // What the run did not come to is absent.
  EXPECT_TRUE(certificate.angle_fit.has_value());
  EXPECT_FALSE(certificate.radii.has_value());
  EXPECT_FALSE(certificate.triangulation->delaunay_rounds.has_value());
}

/// A solve that goes wrong in so many rounds, and what it was asked to lock.
struct FakeSolve {
  int flipped_rounds = 0;
  int rounds = 0;
  std::vector<int> locked_before = {};

  StatusOr<std::vector<Index>> operator()(const std::vector<bool>& locked) {
    locked_before.push_back(static_cast<int>(std::count(locked.begin(), locked.end(), true)));
    return rounds++ < flipped_rounds ? std::vector<Index>{7} : std::vector<Index>();
  }
};

bool LockOne(const std::vector<Index>&, std::vector<bool>* locked) {
  const auto free = std::find(locked->begin(), locked->end(), false);
  if (free == locked->end()) return false;
  *free = true;
  return true;
}

TEST(SolveLockingFlipped, LocksAfterEveryRoundThatFlips) {
  FakeSolve solve{2};
  const auto flipped = SolveLockingFlipped(std::vector<bool>(9, false), std::ref(solve), LockOne);
  ASSERT_TRUE(flipped.ok());
  EXPECT_TRUE(flipped->empty());
  EXPECT_EQ(solve.locked_before, (std::vector<int>{0, 1, 2}));
}

TEST(SolveLockingFlipped, EndsAtItsLimitWithWhatIsLeft) {
  FakeSolve solve{100};
  const auto flipped = SolveLockingFlipped(std::vector<bool>(99, false), std::ref(solve), LockOne);
  EXPECT_EQ(*flipped, std::vector<Index>{7});
  EXPECT_EQ(solve.rounds, kMostLockingRounds);
}

TEST(SolveLockingFlipped, EndsWhereNothingIsLeftToLockOrASolveFails) {
  FakeSolve solve{100};
  EXPECT_FALSE(SolveLockingFlipped({true, false}, std::ref(solve), LockOne)->empty());
  EXPECT_EQ(solve.locked_before, (std::vector<int>{1, 2}));
  const auto failed = SolveLockingFlipped(
      {false}, [](const std::vector<bool>&) { return Status(StatusCode::kCancelled, "enough"); },
      LockOne);
  EXPECT_EQ(failed.status().code(), StatusCode::kCancelled);
}

}  // namespace
}  // namespace cirque

#include "cirque/pipeline/solve_flat_metric.h"

#include <gtest/gtest.h>

#include "cirque/core/metric.h"
#include "cirque/intrinsic/intrinsic_surface.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

/// A solve on a surface's own triangles.
struct Solved {
  Solved(const Surface& surface, FitStart start, const ParameterizeOptions& options = {}) {
    const EdgeLengths lengths = MeasureEdgeLengths(surface);
    const IntrinsicSurface measured = MeasureSurface(surface.triangulation, lengths);
    const ConeTargets targets = FreeBoundaryTargets(surface.triangulation);
    flat.intrinsic = {surface.triangulation, lengths, {}, {}};
    status = SolveFlatMetric({measured, targets, options, {}}, start, &certificate, &flat);
  }

  bool ByInteriorPoint() const { return certificate.angle_fit->angle_fit_retried.has_value(); }

  Certificate certificate;
  FlatSurface flat;
  Status status;
};

TEST(SolveFlatMetric, AfterWanderingTheInteriorPointFindsWhatTheDualWould) {
  for (const char* name : {"bumpy_terrain", "spherical_cap"}) {
    const Surface surface = GeneratedSurface(name, 400);
    const Solved dual(surface, FitStart::kZero);
    const Solved other(surface, FitStart::kAfterWandering);
    ASSERT_TRUE(dual.status.ok() && other.status.ok()) << name << other.status.message();
    EXPECT_FALSE(dual.ByInteriorPoint());
    EXPECT_TRUE(other.ByInteriorPoint());
    const double apart = (dual.flat.angles.value - other.flat.angles.value).cwiseAbs().maxCoeff();
    EXPECT_LT(apart, 1e-6) << name;
  }
}

TEST(SolveFlatMetric, WhatFewStepsOfTheDualDoNotDecideTheInteriorPointDoes) {
  ParameterizeOptions few;
  few.max_iterations = 7;  // of which the angles have two
  const Solved solved(GeneratedSurface("bumpy_terrain", 400), FitStart::kZero, few);
  ASSERT_TRUE(solved.status.ok()) << solved.status.message();
  EXPECT_TRUE(solved.ByInteriorPoint());
}

TEST(SolveFlatMetric, AfterWanderingAnObjectiveOfThetaIsFittedByItsOwnSolver) {
  const Surface surface = GeneratedSurface("bumpy_terrain", 400);
  ParameterizeOptions options;
  options.angle_objective = "barrier";
  const Solved solved(surface, FitStart::kAfterWandering, options);
  ASSERT_TRUE(solved.status.ok()) << solved.status.message();
  EXPECT_FALSE(solved.ByInteriorPoint());
}

TEST(SolveFlatMetric, WithoutAnglesThereAreNoMultipliersToBeginTheNextFitWith) {
  const Surface surface = Kleetope(GeneratedSurface("bumpy_terrain", 200));
  for (const FitStart start : {FitStart::kZero, FitStart::kAfterWandering}) {
    const Solved solved(surface, start);
    EXPECT_EQ(solved.status.code(), StatusCode::kInfeasible);
    EXPECT_FALSE(solved.flat.infeasibility.empty());
    EXPECT_EQ(solved.flat.multipliers.size(), 0);
  }
}

}  // namespace
}  // namespace cirque

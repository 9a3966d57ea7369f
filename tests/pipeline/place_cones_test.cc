#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/cones/cone.h"
#include "cirque/cones/cone_heuristic.h"
#include "cirque/cones/registry.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"
#include "cirque/mesh/surface.h"
#include "cirque/pipeline/cone_stages.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

StatusOr<ConeTargets> Place(const Surface& surface, const ParameterizeOptions& options) {
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  return PlaceCones(ConeSite(MeasureSurface(surface.triangulation, lengths)), options);
}

/// What the cones take away from the angle sums, in all [rad].
double TotalCurvature(const Triangulation& t, const ConeTargets& targets) {
  double total = 0;
  for (const Cone& cone : ConesOf(t, targets)) total += 2 * kPi - cone.lower;
  return total;
}

TEST(PlaceCones, OfAClosedSurfaceObeyGaussBonnet) {
  for (const char* name : {"sphere", "blob", "torus", "double_torus"}) {
    SCOPED_TRACE(name);
    const Surface surface = GeneratedSurface(name, 400);
    const Triangulation& t = surface.triangulation;
    const auto targets = Place(surface, {});
    ASSERT_TRUE(targets.ok()) << targets.status().message();
    EXPECT_NEAR(TotalCurvature(t, *targets), 2 * kPi * EulerCharacteristic(t), 1e-9);
    EXPECT_EQ(ConesOf(t, *targets).empty(), EulerCharacteristic(t) == 0);
  }
}

TEST(PlaceCones, ATorusGetsConesWhereItsAreaWouldRangeFar) {
  // A spike on the ring: seen from the rest, its end is small.
  const Surface torus = GeneratedSurface("torus", 4000);
  Eigen::Vector3d outermost = torus.position[0];
  for (const Eigen::Vector3d& x : torus.position) {
    if (x.x() > outermost.x()) outermost = x;
  }
  const Surface spiked = Moved(torus, [&](const Eigen::Vector3d& x) -> Eigen::Vector3d {
    return x + 20 * std::exp(-12 * (x - outermost).squaredNorm()) * Eigen::Vector3d::UnitX();
  });
  const auto plain = Place(torus, {}), placed = Place(spiked, {});
  ASSERT_TRUE(plain.ok() && placed.ok());
  EXPECT_TRUE(ConesOf(torus.triangulation, *plain).empty());
  EXPECT_EQ(ConesOf(spiked.triangulation, *placed).size(), 8u);
  EXPECT_NEAR(TotalCurvature(spiked.triangulation, *placed), 0, 1e-9);
}

/// The surface without the face whose vertices have fewest corners.
Surface Punctured(const Surface& surface) {
  const Triangulation& t = surface.triangulation;
  const std::vector<Index> corners = CornersPerVertex(t);
  const auto around = [&](Index f) {
    return corners[t.vertex[3 * f]] + corners[t.vertex[3 * f + 1]] + corners[t.vertex[3 * f + 2]];
  };
  Index fewest = 0;
  for (Index f = 1; f < t.num_faces(); ++f) {
    if (around(f) < around(fewest)) fewest = f;
  }
  PolygonSoup soup = TrianglesOf(surface);
  soup.corner.erase(soup.corner.begin() + 3 * fewest, soup.corner.begin() + 3 * fewest + 3);
  soup.first_corner.pop_back();
  return SurfaceOf(soup);
}

TEST(PlaceCones, HandlesNeedThemWhereTheBoundaryCannotTurnSoFar) {
  const Surface surface = Punctured(GeneratedSurface("double_torus", 400));
  const auto targets = Place(surface, {});
  ASSERT_TRUE(targets.ok()) << targets.status().message();
  EXPECT_GE(ConesOf(surface.triangulation, *targets).size(), 8u);
  EXPECT_LT(TotalCurvature(surface.triangulation, *targets), 0);
}

/// By what power of e areas range with so many cones by greedy, as the linear model predicts.
double PredictedRange(const ConeProblem& problem, int cones) {
  const auto chosen =
      (*MakeConeHeuristic("greedy", {{"cones", std::to_string(cones)}}))->Choose(problem);
  const Eigen::VectorXd u = PredictedLogScale(problem, *chosen);
  return 2 * (u.maxCoeff() - u.minCoeff());
}

TEST(ConeSite, KeepsItsProblemFromTheSecondTimeOn) {
  const Surface sphere = GeneratedSurface("sphere", 400);
  const EdgeLengths lengths = MeasureEdgeLengths(sphere);
  const IntrinsicSurface measured = MeasureSurface(sphere.triangulation, lengths);
  const ConeSite site(measured);
  const std::weak_ptr<const ConeProblem> first = site.Problem();
  EXPECT_TRUE(first.expired());
  const std::weak_ptr<const ConeProblem> second = site.Problem();
  EXPECT_EQ(second.lock(), site.Problem());
  EXPECT_NEAR(second.lock()->TotalCurvature(), 4 * kPi, 1e-12);
  // Placed again the cones are those that were placed first.
  const StatusOr<ConeTargets> once = PlaceCones(ConeSite(measured), {}),
                              again = PlaceCones(site, {});
  ASSERT_TRUE(once.ok() && again.ok());
  EXPECT_EQ(ConesOf(sphere.triangulation, *once).size(), 8u);
  EXPECT_EQ(once->lower, again->lower);
}

TEST(PlaceCones, OneChartGetsAsManyAsItNeeds) {
  const Surface needle = Moved(GeneratedSurface("sphere", 8000), [](const Eigen::Vector3d& x) {
    return Eigen::Vector3d(100 * x.x(), x.y(), x.z());
  });
  const EdgeLengths lengths = MeasureEdgeLengths(needle);
  const IntrinsicTriangulation delaunay = MakeIntrinsicDelaunay(needle.triangulation, lengths);
  const ConeProblem problem(delaunay.triangulation, delaunay.lengths);
  const IntrinsicSurface measured = MeasureSurface(needle.triangulation, lengths);
  const int count = ConesForOneChart(ConeSite(measured), 4);
  EXPECT_GT(count, 4);
  EXPECT_GT(PredictedRange(problem, count / 2), 28);
  EXPECT_LE(PredictedRange(problem, count), 28);
  EXPECT_EQ(ConesForOneChart(ConeSite(measured), 1000), 1000);
  const Surface sphere = GeneratedSurface("sphere", 400);
  const EdgeLengths of_sphere = MeasureEdgeLengths(sphere);
  EXPECT_EQ(ConesForOneChart(ConeSite(MeasureSurface(sphere.triangulation, of_sphere)), 4), 4);
  const auto placed = Place(needle, {});
  ASSERT_TRUE(placed.ok());
  EXPECT_GE(ConesOf(needle.triangulation, *placed).size(), 8u);
}

TEST(PlaceCones, ABoundaryNeedsNone) {
  const Surface surface = GeneratedSurface("annulus", 300);
  const ConeTargets free = FreeBoundaryTargets(surface.triangulation);
  const auto targets = Place(surface, {});
  EXPECT_EQ(targets->lower, free.lower);
  EXPECT_EQ(targets->upper, free.upper);
}

TEST(PlaceCones, ScaleDoesNotMatter) {
  const Surface blob = GeneratedSurface("blob", 300);
  const Surface large = Moved(blob, [](const Eigen::Vector3d& x) -> Eigen::Vector3d {
    return 256 * x;  // exact
  });
  for (const char* cones : {"", "greedy:cones=5", "curvature_peaks:cones=6"}) {
    ParameterizeOptions options;
    options.cones = cones;
    const auto small = Place(blob, options), scaled = Place(large, options);
    ASSERT_TRUE(small.ok()) << small.status().message();
    ASSERT_TRUE(scaled.ok()) << scaled.status().message();
    EXPECT_EQ(ConesOf(blob.triangulation, *small).size(),
              ConesOf(blob.triangulation, *scaled).size());
    for (std::size_t v = 0; v < small->lower.size(); ++v) {
      EXPECT_NEAR(small->lower[v], scaled->lower[v], 1e-9) << cones;
    }
  }
}

TEST(PlaceCones, TheBudgetIsKeptAndAnglesRounded) {
  const Surface surface = GeneratedSurface("blob", 500);
  ParameterizeOptions options;
  options.cones = "greedy";
  options.cone_budget = 5;
  const auto cones = ConesOf(surface.triangulation, *Place(surface, options));
  EXPECT_LE(cones.size(), 5u);
  EXPECT_GE(cones.size(), 2u);
  options.cone_angles = "pi/2";
  const auto rounded = ConesOf(surface.triangulation, *Place(surface, options));
  ASSERT_FALSE(rounded.empty());
  for (const Cone& cone : rounded) {
    EXPECT_NEAR(std::remainder(cone.lower, kPi / 2), 0, 1e-12);
    EXPECT_EQ(cone.lower, cone.upper);
  }
  options.cone_angles = "ranges:width=0.2";
  for (const Cone& cone : ConesOf(surface.triangulation, *Place(surface, options))) {
    EXPECT_GT(cone.upper - cone.lower, 0.1);
  }
}

TEST(PlaceCones, WhatDoesNotFitIsRefused) {
  const Surface surface = GeneratedSurface("sphere", 100);
  const auto refusal = [&](const std::string& cones, int budget, const std::string& angles) {
    ParameterizeOptions options;
    options.cones = cones;
    options.cone_budget = budget;
    options.cone_angles = angles;
    const auto targets = Place(surface, options);
    EXPECT_EQ(targets.status().code(), StatusCode::kInvalidInput);
    return targets.status().message();
  };
  EXPECT_THAT(refusal("", 3, "free"), HasSubstr("a cone budget needs a heuristic"));
  EXPECT_THAT(refusal("gredy", -1, "free"), HasSubstr("did you mean 'greedy'"));
  EXPECT_THAT(refusal("greedy", -1, "pi/7"), HasSubstr("pi/7"));
  EXPECT_THAT(refusal("greedy:colour=red", -1, "free"), HasSubstr("colour"));
}

}  // namespace
}  // namespace cirque

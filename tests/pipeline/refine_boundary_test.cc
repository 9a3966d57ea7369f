#include "cirque/pipeline/refine_boundary.h"

#include <atomic>
#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/cones/cone.h"
#include "cirque/energy/angle_objective.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"
#include "cirque/layout/planar_layout.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/metrics/measure_map.h"
#include "cirque/pipeline/cone_stages.h"
#include "cirque/pipeline/flatten.h"
#include "cirque/pipeline/parameterize.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

Parameterization MapOf(const Surface& surface, const std::string& boundary) {
  ParameterizeRequest request;
  request.options.boundary = boundary;
  request.options.refine_map = "none";
  Parameterization map;
  const Status status = Parameterize(surface, request, {}, &map);
  EXPECT_TRUE(status.ok()) << status.message();
  return map;
}

double Figure(const Surface& surface, const Parameterization& map, const std::string& name) {
  const auto figures =
      MeasureFigures(surface.triangulation, MeasureEdgeLengths(surface), map.uv, {name});
  EXPECT_TRUE(figures.ok());
  return figures->at(name);
}

TEST(LogScaleNorm, GradientIsThatOfSolvingAgain) {
  const Surface surface = GeneratedSurface("bumpy_terrain", 300);
  const IntrinsicTriangulation metric =
      MakeIntrinsicDelaunay(surface.triangulation, MeasureEdgeLengths(surface));
  const IntrinsicSurface measured = MeasureSurface(metric.triangulation, metric.lengths);
  ParameterizeOptions options;
  options.triangulation = SolvedTriangulation::kInput;
  const auto objective = *AngleObjectiveOf(options);
  ConeTargets targets = FreeBoundaryTargets(metric.triangulation);
  BoundaryProblem problem(measured, measured, targets);
  const Eigen::VectorXd sums = *(*ParseBoundaryShape("isometric"))->Choose(&problem);
  for (const Index v : problem.boundary()) targets.lower[v] = targets.upper[v] = sums[v];
  const auto flatten = [&](const ConeTargets& of) {
    Certificate certificate;
    FlatSurface flat;
    EXPECT_TRUE(Flatten({measured, of, options, {}}, &certificate, &flat).ok());
    return flat;
  };
  const FlatSurface flat = flatten(targets);
  const Index gains = problem.boundary()[3], loses = problem.boundary()[20];
  for (const int power : {2, 8}) {
    const Eigen::VectorXd gradient = LogScaleNormGradient(flat, targets, *objective, power);
    const auto norm = [&](double change) {
      ConeTargets moved = targets;
      moved.lower[gains] = moved.upper[gains] += change;
      moved.lower[loses] = moved.upper[loses] -= change;
      return LogScaleNorm(flatten(moved), power);
    };
    const double step = 1e-5, slope = (norm(step) - norm(-step)) / (2 * step);
    ASSERT_GT(std::abs(slope), 1e-9);
    EXPECT_NEAR(gradient[gains] - gradient[loses], slope, 1e-4 * std::abs(slope));
  }
}

TEST(RefineBoundary, LowersWhatThePredictionLeft) {
  for (const char* generator : {"bumpy_terrain", "hemisphere"}) {
    const Surface surface = GeneratedSurface(generator, 1000);
    for (const char* shape : {"least_area", "least_max"}) {
      SCOPED_TRACE(std::string(generator) + " " + shape);
      // From a quarter of the way to the predicted least, where steps have something to do.
      const std::string quarter = std::string(shape) + ":share=0.25";
      const Parameterization predicted = MapOf(surface, quarter);
      const Parameterization refined = MapOf(surface, quarter + ",steps=4");
      EXPECT_FALSE(predicted.certificate.boundary->boundary_steps.has_value());
      const BoundarySummary& summary = *refined.certificate.boundary;
      EXPECT_GE(*summary.boundary_steps, 1);
      EXPECT_GE(*summary.boundary_solves, *summary.boundary_steps);
      EXPECT_LT(*summary.boundary_log_scale_after, *summary.boundary_log_scale_before);
      if (std::string(shape) == "least_area") {
        EXPECT_LE(Figure(surface, refined, "log_scale_l2"),
                  Figure(surface, predicted, "log_scale_l2") + 1e-4);
      }
      // The metric that comes out has the angle sums that it was refined to, and is as flat.
      const std::vector<double> sums =
          VertexAngleSums(surface.triangulation, refined.flat.on_input.angles);
      const std::vector<bool> boundary = BoundaryVertices(surface.triangulation);
      double total = 0;
      for (Index v = 0; v < surface.triangulation.num_vertices; ++v) {
        EXPECT_NEAR(sums[v], boundary[v] ? refined.targets.lower[v] : 2 * kPi, 1e-9);
        if (boundary[v]) total += kPi - sums[v];
      }
      EXPECT_NEAR(total, 2 * kPi, 1e-9);
      EXPECT_EQ(refined.certificate.overlap, "injective");
    }
  }
}

TEST(RefineBoundary, ReachesAboutTheLeastFromAnywhere) {
  const Surface surface = GeneratedSurface("bumpy_terrain", 1000);
  const auto after = [&](const char* boundary) {
    return *MapOf(surface, boundary).certificate.boundary->boundary_log_scale_after;
  };
  const double from_prediction = after("least_area:steps=8,filter=0.1");
  const double from_isometric = after("least_area:steps=8,filter=0.1,share=0");
  EXPECT_NEAR(from_isometric, from_prediction, 0.02 * from_prediction);
}

/// Nothing can be lowered, and the angles of four points on a circle have no derivative.
TEST(RefineBoundary, LeavesWhatIsFlatAsItIs) {
  const Surface strip = FlatStrip(12, 8);
  for (const char* boundary : {"least_area:steps=5", "least_max:steps=5"}) {
    const Certificate& certificate = MapOf(strip, boundary).certificate;
    EXPECT_EQ(certificate.boundary->boundary_steps, 0) << boundary;
    EXPECT_LT(*certificate.boundary->boundary_log_scale_after, 1e-9) << boundary;
    EXPECT_EQ(certificate.overlap, "injective") << boundary;
  }
}

/// A flat strip whose inner vertices are moved about: of a regular one, four points of every square lie
/// on a circle however it is bent, which no angles with a margin allow.
Surface UnevenStrip() {
  Surface strip = FlatStrip(60, 2);
  int i = 0;
  for (Eigen::Vector3d& p : strip.position) {
    if (p.y() == 1 && p.x() > 0 && p.x() < 60) p += 0.1 * Eigen::Vector3d(i % 5 - 2, i % 3 - 1, 0);
    ++i;
  }
  return strip;
}

/// A strip whose long sides bend until its ends lie one on the other.
struct Ring {
  Ring() : strip(UnevenStrip()), lengths(MeasureEdgeLengths(strip)) {}

  Eigen::VectorXd Bent(const BoundaryProblem& problem, double angle) const {
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(strip.triangulation.num_vertices);
    for (const Index v : problem.boundary()) {
      const Eigen::Vector3d& x = strip.position[v];
      const bool side = x.x() > 0 && x.x()<60, end = x.y()> 0 && x.y() < 2;
      sums[v] = side || end ? kPi : kPi / 2;
      if (side) sums[v] += x.y() == 0 ? angle : -angle;
    }
    return *problem.FitToGaussBonnet(sums);
  }

  const Surface strip;
  const EdgeLengths lengths;
};

TEST(RefineBoundary, StepsBackFromAnImageThatOverlaps) {
  const Ring ring;
  const Triangulation& t = ring.strip.triangulation;
  const IntrinsicSurface surface = MeasureSurface(t, ring.lengths);
  const ConeTargets free = FreeBoundaryTargets(t);
  const BoundaryProblem problem(surface, surface, free);
  const PredictedBoundary predicted = {ring.Bent(problem, 0.13), ring.Bent(problem, 0)};
  const auto overlaps = [&](const FlatSurface& flat) {
    const PlanarLayout layout = LayOutByDirections(t, flat.on_input.angles, flat.on_input.lengths);
    return OverlapsItself(t, layout.uv);
  };
  const std::atomic<bool> stop = true;
  for (const bool cancelled : {false, true}) {
    ConeTargets targets = free;
    for (const Index v : problem.boundary()) {
      targets.lower[v] = targets.upper[v] = predicted.angle_sums[v];
    }
    const ParameterizeOptions options;
    Certificate certificate;
    FlatSurface flat;
    const Status flattened = Flatten({surface, targets, options, {}}, &certificate, &flat);
    ASSERT_TRUE(flattened.ok()) << flattened.message();
    ASSERT_TRUE(overlaps(flat));
    SolveControl control;
    if (cancelled) control.cancelled = &stop;
    const Status status = RefineBoundary({surface, free, options, control}, {.steps = 3}, problem,
                                         predicted, &certificate, &targets, &flat);
    if (cancelled) {
      EXPECT_EQ(status.code(), StatusCode::kCancelled);
      continue;
    }
    ASSERT_TRUE(status.ok()) << status.message();
    EXPECT_FALSE(overlaps(flat));
    EXPECT_GE(*certificate.boundary->boundary_overlaps_avoided, 1);
    EXPECT_LT(*certificate.boundary->boundary_log_scale_after,
              *certificate.boundary->boundary_log_scale_before);
  }
}

TEST(RefineBoundary, NeedsTheCirclePattern) {
  ParameterizeOptions options;
  options.boundary = "least_area:steps=2";
  EXPECT_TRUE(CheckOptions(options).ok());
  options.pattern = PatternKind::kEquivalence;
  EXPECT_THAT(CheckOptions(options).message(), HasSubstr("pattern = circle"));
  options.boundary = "least_area:steps=-1";
  EXPECT_THAT(CheckOptions(options).message(), HasSubstr("steps"));
}

}  // namespace
}  // namespace cirque

#include "cirque/radii/solve_log_radii.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "cirque/angles/registry.h"
#include "cirque/energy/circle_pattern_energy.h"
#include "cirque/math/clausen.h"
#include "cirque/mesh/preflight.h"
#include "cirque/radii/pattern_volume.h"

#include "tests/common/renumbering.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

LogRadiiResult Solve(const Triangulation& t, const CoherentAngles& angles) {
  LogRadiiResult result;
  const Status status = SolveLogRadii(t, angles, **MakeSolverStrategy("newton"), {}, &result);
  EXPECT_TRUE(status.ok()) << status.message();
  return result;
}

TEST(SolveLogRadii, RegularFanHasEqualRadii) {
  const Surface fan = Fan(6, 0.0);
  const LogRadiiResult result =
      Solve(fan.triangulation, {Eigen::VectorXd::Constant(18, kPi / 3), 1e-3});
  EXPECT_LT(result.log_radii.value.lpNorm<Eigen::Infinity>(), 1e-14);
  EXPECT_LT(result.RelativeGap(), 1e-14);
}

// Two right triangles across their hypotenuse: the angles there add up to pi, their circles touch.
TEST(SolveLogRadii, AnglesOnTheRimOfTheCoherentOnesHaveNoPattern) {
  const Surface square =
      *SurfaceFromTriangles({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  const Triangulation& t = square.triangulation;
  for (const double margin : {0.0, 1e-17}) {
    CoherentAngles angles = {AnglesOf(square).value, margin};
    for (Index h = 0; h < t.num_halfedges(); ++h) {
      if (t.twin[h] != kNone) angles.value[h] = kPi / 2 - margin;
    }
    LogRadiiResult result;
    const Status status = SolveLogRadii(t, angles, **MakeSolverStrategy("newton"), {}, &result);
    EXPECT_EQ(status.code(), StatusCode::kNotConverged);
    EXPECT_NE(status.message().find("faces 0 and 1"), std::string::npos) << status.message();
    EXPECT_EQ(result.log_radii.value, Eigen::VectorXd::Zero(2));
  }
}

TEST(SolveLogRadii, FlatPatchGetsItsOwnCircumradii) {
  const Surface patch = GeneratedSurface("flat_delaunay_patch", 1500);
  const CornerAngles angles = AnglesOf(patch);
  const EdgeLengths lengths = MeasureEdgeLengths(patch);
  const LogRadiiResult result = Solve(patch.triangulation, {angles.value, 0});
  Eigen::VectorXd ratio(patch.triangulation.num_faces());
  for (Index f = 0; f < ratio.size(); ++f) {
    const double radius =
        lengths.value[patch.triangulation.edge[3 * f]] / (2 * std::sin(angles.value[3 * f]));
    ratio[f] = result.log_radii.value[f] - std::log(radius);
  }
  EXPECT_LT(ratio.maxCoeff() - ratio.minCoeff(), 1e-9);
  EXPECT_LE(result.solve.num_iterations(), 2);
}

/// Angles that are coherent but not yet a pattern: the flat patch's, pushed along A's kernel about
/// interior vertices.
TEST(SolveLogRadii, FlatAnglesCloseUpAndTheGapVanishes) {
  const Surface patch = GeneratedSurface("flat_delaunay_patch", 600);
  const Triangulation& t = patch.triangulation;
  CoherentAngles angles{AnglesOf(patch).value, 0};
  const std::vector<bool> boundary = BoundaryVertices(t);
  // Around one vertex, turning each triangle's two far corners against each other keeps all vertex
  // sums.
  Index v = 0;
  while (boundary[v]) ++v;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (t.vertex[h] != v) continue;
    angles.value[Triangulation::Next(h)] += 0.02;
    angles.value[Triangulation::Prev(h)] -= 0.02;
  }
  const LogRadiiResult result = Solve(t, angles);
  const CornerAngles flat = FlatCornerAngles(t, angles, result.log_radii);
  for (Index f = 0; f < t.num_faces(); ++f) {
    EXPECT_NEAR(flat.value.segment<3>(3 * f).sum(), kPi, 1e-10);
  }
  EXPECT_GT((flat.value - angles.value).lpNorm<Eigen::Infinity>(), 1e-3);
  EXPECT_LT(result.RelativeGap(), 1e-12);
  // Both faces beside an edge give it the same length.
  const EdgeLengths lengths = FlatEdgeLengths(t, flat, result.log_radii);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const double length = 2 * std::exp(result.log_radii.value[h / 3]) * std::sin(flat.value[h]);
    EXPECT_NEAR(length / lengths.value[t.edge[h]], 1, 1e-10);
  }
}

/// The coherent angles of a curved surface.
CoherentAngles FittedAngles(const Surface& surface) {
  const ConeTargets targets = FreeBoundaryTargets(surface.triangulation);
  const AngleConstraints constraints(surface.triangulation, targets);
  const CornerAngles reference = AnglesOf(surface);
  AngleFitResult fit;
  const Status status =
      FitAngles({constraints, reference.value, 1e-3}, *AngleObjectives().Find("quadratic"),
                **MakeAngleSolver("newton"), {}, &fit);
  EXPECT_TRUE(status.ok()) << status.message();
  return fit.angles;
}

/// phi_i = atan2(sin theta, e^{rho_i - rho_j} - cos theta) opposite inner edges, theta* on the
/// boundary: written out from the thesis, without the library's functions.
double HalfAngleAt(const Triangulation& t, const CoherentAngles& angles, const LogRadii& rho,
                   Index h) {
  const Index g = t.twin[h];
  if (g == kNone) return angles.value[h];
  const double theta = kPi - angles.value[h] - angles.value[g];
  const double ratio = std::exp(rho.value[h / 3] - rho.value[g / 3]);
  return std::atan2(std::sin(theta), ratio - std::cos(theta));
}

double LargestGradient(const Triangulation& t, const CoherentAngles& angles, const LogRadii& rho) {
  double largest = 0;
  for (Index f = 0; f < t.num_faces(); ++f) {
    double gradient = 2 * kPi;
    for (Index h = 3 * f; h < 3 * f + 3; ++h) gradient -= 2 * HalfAngleAt(t, angles, rho, h);
    largest = std::max(largest, std::abs(gradient));
  }
  return largest;
}

TEST(SolveLogRadii, TheGradientOfTheThesisVanishes) {
  for (const char* name : {"bumpy_terrain", "spherical_cap", "capped_tube"}) {
    SCOPED_TRACE(name);
    const Surface surface = GeneratedSurface(name, 500);
    const CoherentAngles angles = FittedAngles(surface);
    const LogRadiiResult result = Solve(surface.triangulation, angles);
    EXPECT_LT(LargestGradient(surface.triangulation, angles, result.log_radii), 1e-9);
    EXPECT_NEAR(result.log_radii.value.mean(), 0, 1e-12);
    EXPECT_GT(result.log_radii.value.lpNorm<Eigen::Infinity>(), 0.1);
    LogRadii moved = result.log_radii;
    moved.value[7] += 1e-6;
    EXPECT_GT(LargestGradient(surface.triangulation, angles, moved), 1e-8);
  }
}

TEST(SolveLogRadii, AFlatPatchKeepsItsCornerAngles) {
  const Surface patch = GeneratedSurface("flat_delaunay_patch", 900);
  const Triangulation& t = patch.triangulation;
  const CoherentAngles angles{AnglesOf(patch).value, 0};
  const LogRadiiResult result = Solve(t, angles);
  const CornerAngles flat = FlatCornerAngles(t, angles, result.log_radii);
  EXPECT_LT((flat.value - angles.value).lpNorm<Eigen::Infinity>(), 1e-9);
  // Its own lengths, but for one factor.
  const Eigen::VectorXd ratio = FlatEdgeLengths(t, flat, result.log_radii)
                                    .value.cwiseQuotient(MeasureEdgeLengths(patch).value);
  EXPECT_LT(ratio.maxCoeff() / ratio.minCoeff() - 1, 1e-8);
}

TEST(SolveLogRadii, DoNotDependOnNumbering) {
  const Surface surface = GeneratedSurface("bumpy_terrain", 400);
  const CoherentAngles angles = FittedAngles(surface);
  const LogRadiiResult result = Solve(surface.triangulation, angles);
  for (const unsigned seed : {1u, 2u}) {
    const Renumbering r = Renumber(surface.triangulation, seed);
    const LogRadiiResult other =
        Solve(r.triangulation, {r.PerHalfedge(angles.value), angles.epsilon});
    for (Index f = 0; f < surface.triangulation.num_faces(); ++f) {
      EXPECT_NEAR(other.log_radii.value[r.halfedge[3 * f] / 3], result.log_radii.value[f], 1e-9);
    }
    EXPECT_NEAR(other.energy, result.energy, 1e-10 * std::abs(result.energy));
  }
}

TEST(SolveLogRadii, AConstantMoreScalesTheFlatTriangles) {
  const Surface surface = GeneratedSurface("spherical_cap", 300);
  const Triangulation& t = surface.triangulation;
  const CoherentAngles angles = FittedAngles(surface);
  const LogRadii rho = Solve(t, angles).log_radii;
  const CornerAngles flat = FlatCornerAngles(t, angles, rho);
  const EdgeLengths lengths = FlatEdgeLengths(t, flat, rho);
  double before = 0;
  for (const double constant : {-3.0, 0.5, 20.0}) {
    const LogRadii shifted{(rho.value.array() + constant).matrix()};
    EXPECT_LT((FlatCornerAngles(t, angles, shifted).value - flat.value).lpNorm<Eigen::Infinity>(),
              1e-12);
    const Eigen::VectorXd larger = FlatEdgeLengths(t, flat, shifted).value;
    EXPECT_LT(
        (larger.cwiseQuotient(lengths.value).array() / std::exp(constant) - 1).abs().maxCoeff(),
        1e-12);
    EXPECT_GT(larger.minCoeff(), before * lengths.value.minCoeff());
    before = std::exp(constant);
    EXPECT_LT(LargestGradient(t, angles, shifted), 1e-9);
  }
}

/// Rivin's volume of angles: 2 sum L(alpha) - 2 sum L(theta*) over the inner edges.
double Volume(const Triangulation& t, const Eigen::VectorXd& phi) {
  double volume = 0;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const Index g = t.twin[h];
    if (g == kNone) continue;
    volume += 2 * Lobachevsky(phi[h]) - Lobachevsky(phi[h] + phi[g]);
  }
  return volume;
}

TEST(SolveLogRadii, TheDualIsBelowEveryEnergyAndMeetsTheLeast) {
  const Surface surface = GeneratedSurface("bumpy_terrain", 300);
  const Triangulation& t = surface.triangulation;
  const CoherentAngles angles = FittedAngles(surface);
  const LogRadiiResult result = Solve(t, angles);
  const CirclePatternEnergy energy(t, angles);
  const CornerAngles flat = FlatCornerAngles(t, angles, result.log_radii);
  EXPECT_LT(result.RelativeGap(), 1e-12);
  EXPECT_NEAR(result.dual_energy, Volume(t, flat.value), 1e-10 * std::abs(result.energy));
  // Coherent angles with these theta that are not the pattern's have less volume, radii that are
  // not the pattern's more energy.
  EXPECT_LT(Volume(t, angles.value), result.energy - 1e-6);
  std::srand(5);
  for (const double size : {1e-3, 0.1, 2.0}) {
    const Eigen::VectorXd rho =
        result.log_radii.value + size * Eigen::VectorXd::Random(t.num_faces());
    double value = 0;
    ASSERT_TRUE(energy.Evaluate(rho.data(), &value, nullptr));
    EXPECT_GT(value, result.energy) << size;
    EXPECT_GT(value, Volume(t, angles.value)) << size;
  }
}

TEST(SolveLogRadii, TheStartAloneIsNear) {
  const Surface surface = GeneratedSurface("capped_tube", 500);
  const Triangulation& t = surface.triangulation;
  const CoherentAngles angles = FittedAngles(surface);
  const CirclePatternEnergy energy(t, angles);
  const auto strategy = *MakeSolverStrategy("newton");
  RadiiSystem system(t, *strategy);
  double last = LargestGradient(t, angles, {Eigen::VectorXd::Zero(t.num_faces())});
  for (const double tolerance : {1.0, 1e-2, 1e-6}) {
    Eigen::VectorXd rho;
    const SolveSummary summary =
        MaximizePatternVolume(t, angles, energy, tolerance, system.Get(), &rho);
    EXPECT_GT(summary.linear_solves, 0);
    const double gradient = LargestGradient(t, angles, {rho});
    EXPECT_LE(gradient, std::max(tolerance, 1e-5));  // it ends where it gains no more
    EXPECT_LE(gradient, last);
    last = gradient;
  }
}

TEST(SolveLogRadii, ASystemPreparedBeforehandChangesNothing) {
  const Surface surface = GeneratedSurface("bumpy_terrain", 300);
  const CoherentAngles angles = FittedAngles(surface);
  const auto strategy = *MakeSolverStrategy("auto");
  RadiiSystem system(surface.triangulation, *strategy);
  LogRadiiResult with, without;
  ASSERT_TRUE(SolveLogRadii(surface.triangulation, angles, *strategy, {}, &system, &with).ok());
  ASSERT_TRUE(SolveLogRadii(surface.triangulation, angles, *strategy, {}, &without).ok());
  EXPECT_EQ(with.log_radii.value, without.log_radii.value);
}

Status StatusOf(const Triangulation& t, const CoherentAngles& angles, const OptionMap& options,
                const SolveControl& control, LogRadiiResult* result) {
  return SolveLogRadii(t, angles, **MakeSolverStrategy("newton", options), control, result);
}

TEST(SolveLogRadii, LimitsAndCancellationAreNamed) {
  const Surface surface = GeneratedSurface("capped_tube", 500);
  const Triangulation& t = surface.triangulation;
  const CoherentAngles angles = FittedAngles(surface);
  LogRadiiResult result;
  Status status = StatusOf(t, angles, {{"max_iterations", "0"}}, {}, &result);
  EXPECT_EQ(status.code(), StatusCode::kNotConverged) << status.message();
  EXPECT_NE(status.message().find("iteration_limit"), std::string::npos) << status.message();
  EXPECT_GT(result.gradient_max, 1e-9);
  EXPECT_GT(result.RelativeGap(), 0);
  status = StatusOf(t, angles, {{"max_seconds", "0"}}, {}, &result);
  EXPECT_EQ(status.code(), StatusCode::kNotConverged);
  EXPECT_NE(status.message().find("time_limit"), std::string::npos) << status.message();
  const std::atomic<bool> cancelled = true;
  EXPECT_EQ(StatusOf(t, angles, {}, {{}, &cancelled}, &result).code(), StatusCode::kCancelled);
}

TEST(SolveLogRadii, IntersectionAnglesOfNoPatternAreRefused) {
  // An icosahedron whose first face would need half angles of pi in all, from three theta* of 0.3,
  // which are all that they may add up to; the sum over all faces is as it must be.
  const Triangulation t = RegularPolyhedron(20).triangulation;
  CoherentAngles angles{Eigen::VectorXd::Constant(60, 0.5 * (20 * kPi - 0.9) / 27), 0};
  for (Index h = 0; h < 3; ++h) angles.value[h] = angles.value[t.twin[h]] = 0.15;
  LogRadiiResult result;
  const Status status = StatusOf(t, angles, {}, {}, &result);
  EXPECT_EQ(status.code(), StatusCode::kNotConverged);
  EXPECT_NE(status.message().find("gradient"), std::string::npos) << status.message();
  EXPECT_GT(result.gradient_max, 2 * kPi - 2 * 0.9 - 1e-6);
}

}  // namespace
}  // namespace cirque

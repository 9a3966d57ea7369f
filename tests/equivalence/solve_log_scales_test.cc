// Flat metrics by discrete conformal equivalence: known answers, any cones, boundaries.
#include "cirque/equivalence/solve_log_scales.h"

#include <atomic>
#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/equivalence/double_surface.h"
#include "cirque/intrinsic/flip_complex.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/intrinsic/ptolemy_complex.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using testing::HasSubstr;

Status Solve(const Surface& surface, const ConeTargets& targets, LogScalesResult* result,
             KeptEdges kept = KeptEdges::kBoundary, const std::string& strategy = "newton") {
  return SolveLogScales(surface.triangulation, MeasureEdgeLengths(surface), targets, kept,
                        **MakeSolverStrategy(strategy), {}, result);
}

ConeTargets Fixed(const std::vector<double>& sums) { return {sums, sums}; }

/// Angle sums with Gauss-Bonnet, each a random multiple of their mean, from `least` to `most` times
/// as far as can be.
ConeTargets RandomCones(const Surface& surface, double least, unsigned seed) {
  const Triangulation& t = surface.triangulation;
  std::mt19937 random(seed);
  std::vector<double> sums;
  double total = 0;
  for (Index v = 0; v < t.num_vertices; ++v) {
    sums.push_back(least + std::pow(std::ldexp(static_cast<double>(random()), -32), 4));
    total += sums.back();
  }
  for (double& sum : sums) sum *= kPi * t.num_faces() / total;
  return Fixed(sums);
}

/// That the result is what it says: flips that lead from the surface to its triangulation, Ptolemy's
/// lengths scaled, Euclidean and Delaunay, with these angle sums.
void ExpectSound(const Triangulation& t, const EdgeLengths& lengths, const Eigen::VectorXd& scale,
                 const std::vector<double>& sums, const LogScalesResult& result) {
  FlipComplex replayed(t, lengths);
  const auto& flips = result.intrinsic.flips;
  for (int i = 0; i < result.euclidean_flips; ++i) {
    replayed.Flip(flips[i], *replayed.OtherDiagonal(flips[i]), kNone);
  }
  const Triangulation start = replayed.MakeTriangulation(t.num_vertices);
  PtolemyComplex ptolemy(start, replayed.MakeLengths(start).value.array().log());
  for (std::size_t i = result.euclidean_flips; i < flips.size(); ++i) ptolemy.Flip(flips[i]);
  const Triangulation& solved = result.intrinsic.triangulation;
  EXPECT_EQ(ptolemy.MakeTriangulation(t.num_vertices).vertex, solved.vertex);
  EXPECT_EQ(ptolemy.MakeTriangulation(t.num_vertices).twin, solved.twin);
  for (Index h = 0; h < solved.num_halfedges(); ++h) {
    EXPECT_NEAR(result.log_lengths[solved.edge[h]], ptolemy.ScaledLogLength(h, scale), 1e-10);
  }
  const EdgeLengths flat{result.log_lengths.array().exp()};
  const CornerAngles angles = MeasureCornerAngles(solved, flat);
  EXPECT_LT((angles.value - result.angles.value).lpNorm<Eigen::Infinity>(), 1e-7);
  EXPECT_GT(result.angles.value.minCoeff(), 0);
  EXPECT_TRUE(NonDelaunayEdges(solved, flat).empty());
  const std::vector<double> reached = VertexAngleSums(solved, result.angles);
  for (std::size_t v = 0; v < sums.size(); ++v) EXPECT_NEAR(reached[v], sums[v], 1e-10);
}

TEST(SolveLogScales, ScalesThatWereAppliedAreTakenBack) {
  const Surface sphere = RegularPolyhedron(20);
  const Triangulation& t = sphere.triangulation;
  EdgeLengths lengths = MeasureEdgeLengths(sphere);
  Eigen::VectorXd u(t.num_vertices);
  for (Index v = 0; v < u.size(); ++v) u[v] = 0.2 * std::sin(5.0 * v);
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    lengths.value[e] *= std::exp(0.5 * (u[t.Tail(h)] + u[t.Tip(h)]));
  }
  const ConeTargets regular = Fixed(std::vector<double>(t.num_vertices, 5 * kPi / 3));
  LogScalesResult result;
  const Status status = SolveLogScales(t, lengths, regular, KeptEdges::kBoundary,
                                       **MakeSolverStrategy("newton"), {}, &result);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_EQ(result.euclidean_flips, 0);
  const Eigen::VectorXd constant = result.log_scale + u;
  EXPECT_LT(constant.maxCoeff() - constant.minCoeff(), 1e-10);
  EXPECT_LE(result.residual, 1e-10);
}

TEST(SolveLogScales, AnyConesOnSurfacesOfAnyGenus) {
  for (const char* generator : {"blob", "torus", "double_torus"}) {
    const Surface surface = GeneratedSurface(generator, 200);
    for (const double least : {0.3, 1e-2, 1e-4}) {
      const ConeTargets targets = RandomCones(surface, least, 7);
      LogScalesResult result;
      const Status status = Solve(surface, targets, &result);
      ASSERT_TRUE(status.ok()) << generator << " " << least << ": " << status.message();
      EXPECT_LE(result.residual, 1e-10);
      EXPECT_GT(static_cast<int>(result.intrinsic.flips.size()), result.euclidean_flips);
      ExpectSound(surface.triangulation, MeasureEdgeLengths(surface), result.log_scale,
                  targets.lower, result);
    }
  }
}

TEST(SolveLogScales, ConesThatNoCornersOfTheInputCouldReach) {
  // A vertex of three corners is to have 5 pi: coherent angles on this triangulation do not exist.
  const Surface surface = Kleetope(GeneratedSurface("torus", 60));
  const Triangulation& t = surface.triangulation;
  const Index cone = t.num_vertices - 1;
  ASSERT_EQ(CornersPerVertex(t)[cone], 3);
  std::vector<double> sums(t.num_vertices, 2 * kPi);
  sums[cone] = 5 * kPi;
  for (Index v = 0; v < 30; ++v) sums[v] -= 0.1 * kPi;
  LogScalesResult result;
  const Status status = Solve(surface, Fixed(sums), &result);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_GT(CornersPerVertex(result.intrinsic.triangulation)[cone], 5);
  ExpectSound(t, MeasureEdgeLengths(surface), result.log_scale, sums, result);
}

TEST(SolveLogScales, EveryNewtonStrategyFindsTheSameMetric) {
  const Surface surface = GeneratedSurface("blob", 150);
  const ConeTargets targets = RandomCones(surface, 0.2, 3);
  LogScalesResult newton;
  ASSERT_TRUE(Solve(surface, targets, &newton).ok());
  for (const char* strategy : {"auto", "newton_cg"}) {
    LogScalesResult other;
    const Status status = Solve(surface, targets, &other, KeptEdges::kBoundary, strategy);
    ASSERT_TRUE(status.ok()) << strategy << ": " << status.message();
    const Eigen::VectorXd difference = newton.log_scale - other.log_scale;
    EXPECT_LT(difference.maxCoeff() - difference.minCoeff(), 1e-8) << strategy;
  }
}

TEST(SolveLogScales, TheFreeBoundaryKeepsItsScale) {
  const Surface disk = GeneratedSurface("bumpy_terrain", 300);
  const Triangulation& t = disk.triangulation;
  const std::vector<bool> boundary = BoundaryVertices(t);
  LogScalesResult result;
  ASSERT_TRUE(Solve(disk, FreeBoundaryTargets(t), &result).ok());
  EXPECT_FALSE(result.doubled);
  const std::vector<double> sums = VertexAngleSums(result.intrinsic.triangulation, result.angles);
  int moved = 0;
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (boundary[v]) {
      EXPECT_EQ(result.log_scale[v], 0);
    } else {
      EXPECT_NEAR(sums[v], 2 * kPi, 1e-10);
      moved += result.log_scale[v] != 0;
    }
  }
  EXPECT_GT(moved, 50);
}

TEST(SolveLogScales, WithoutFlipsTheMetricIsOneOfTheInputsTriangles) {
  const Surface disk = GeneratedSurface("bumpy_terrain", 300);
  const Triangulation& t = disk.triangulation;
  LogScalesResult result;
  ASSERT_TRUE(Solve(disk, FreeBoundaryTargets(t), &result, KeptEdges::kAll).ok());
  EXPECT_TRUE(result.intrinsic.flips.empty());
  EXPECT_EQ(result.intrinsic.triangulation.vertex, t.vertex);
  EXPECT_GT(result.angles.value.minCoeff(), 0);
  const Eigen::VectorXd given = MeasureEdgeLengths(disk).value.array().log();
  const std::vector<double> sums = VertexAngleSums(t, result.angles);
  const std::vector<bool> boundary = BoundaryVertices(t);
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    const double scaled =
        given[e] + 0.5 * (result.log_scale[t.Tail(h)] + result.log_scale[t.Tip(h)]);
    EXPECT_NEAR(result.log_lengths[e], scaled, 1e-14);
  }
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (!boundary[v]) {
      EXPECT_NEAR(sums[v], 2 * kPi, 1e-10);
    }
  }
}

TEST(SolveLogScales, TheDoubledSurfaceHasTwiceTheSumsOnTheBoundary) {
  const Surface disk = GeneratedSurface("bumpy_terrain", 200);
  const Triangulation& t = disk.triangulation;
  // A convex polygon: all boundary vertices turn alike.
  ConeTargets targets = FreeBoundaryTargets(t);
  const std::vector<bool> boundary = BoundaryVertices(t);
  const auto sides = std::count(boundary.begin(), boundary.end(), true);
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (boundary[v]) {
      targets.lower[v] = targets.upper[v] = kPi - 2 * kPi / static_cast<double>(sides);
    }
  }
  const EdgeLengths lengths = MeasureEdgeLengths(disk);
  const DoubledSurface doubled = DoubleSurface(t, lengths);
  LogScalesResult result;
  ASSERT_TRUE(Solve(disk, targets, &result, KeptEdges::kNoEdge).ok());
  ASSERT_TRUE(result.doubled);
  ASSERT_EQ(result.log_scale.size(), t.num_vertices);
  Eigen::VectorXd scale(doubled.triangulation.num_vertices);
  std::vector<double> sums;
  for (Index v = 0; v < scale.size(); ++v) {
    const Index of = doubled.original[v];
    scale[v] = result.log_scale[of];
    sums.push_back((boundary[of] ? 2 : 1) * targets.lower[of]);
  }
  ExpectSound(doubled.triangulation, doubled.lengths, scale, sums, result);
}

TEST(DoubleSurface, IsClosedAndItsOwnMirrorImage) {
  const Surface disk = GeneratedSurface("annulus", 100);
  const Triangulation& t = disk.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(disk);
  const DoubledSurface doubled = DoubleSurface(t, lengths);
  const Triangulation& d = doubled.triangulation;
  EXPECT_EQ(d.num_faces(), 2 * t.num_faces());
  EXPECT_EQ(EulerCharacteristic(d), 2 * EulerCharacteristic(t));
  EXPECT_TRUE(BoundaryLoops(d).empty());
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    EXPECT_EQ(d.vertex[h], t.vertex[h]);
    EXPECT_EQ(d.edge[h], t.edge[h]);
    EXPECT_EQ(doubled.lengths.value[d.edge[h]], lengths.value[t.edge[h]]);
  }
  for (Index h = 0; h < d.num_halfedges(); ++h) {
    ASSERT_EQ(d.twin[d.twin[h]], h);
    EXPECT_EQ(d.Tail(h), d.Tip(d.twin[h]));
  }
  const CornerAngles angles = MeasureCornerAngles(d, doubled.lengths);
  const std::vector<double> once = VertexAngleSums(t, AnglesOf(disk));
  const std::vector<double> twice = VertexAngleSums(d, angles);
  const std::vector<bool> boundary = BoundaryVertices(t);
  for (Index v = 0; v < d.num_vertices; ++v) {
    const Index of = doubled.original[v];
    EXPECT_NEAR(twice[v], (boundary[of] ? 2 : 1) * once[of], 1e-12);
  }
}

TEST(FixedTargets, IntervalsGiveWayToGaussBonnetAlike) {
  const Surface sphere = RegularPolyhedron(20);
  ConeTargets targets = Fixed(std::vector<double>(12, 5 * kPi / 3));
  targets.lower[3] = kPi;
  targets.upper[3] = 2 * kPi;
  targets.lower[5] = 4 * kPi / 3;
  targets.upper[5] = 4 * kPi / 3 + 0.5 * kPi;
  const ConeTargets fixed = FixedTargets(sphere.triangulation, targets);
  const double fraction = 2.0 / 3;  // 2 pi - 2/3 pi of missing pi, width 3/2 pi
  EXPECT_NEAR(fixed.lower[3], kPi + fraction * kPi, 1e-12);
  EXPECT_NEAR(fixed.lower[5], 4 * kPi / 3 + fraction * 0.5 * kPi, 1e-12);
  EXPECT_NEAR(MeasureGaussBonnetDefect(sphere.triangulation, fixed).lower, 0, 1e-12);
  EXPECT_EQ(fixed.lower, fixed.upper);
}

/// Cones whose flat metric has needles of 1 to 1e-11 and more, angles of which lie in the logarithms'
/// digits below a double's.
TEST(SolveLogScales, NeedlesHaveTheirAngleSums) {
  double longest = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const Surface strip = Moved(FlatStrip(3, 2), [](const Eigen::Vector3d& x) -> Eigen::Vector3d {
      return {x.x(), 1e-3 * x.y(), 0.3e-3 * x.x() * x.x()};
    });
    LogScalesResult result;
    const Status status = Solve(strip, RandomCones(strip, 0.1, seed), &result, KeptEdges::kNoEdge);
    ASSERT_TRUE(status.ok()) << seed << ": " << status.message();
    EXPECT_LE(result.residual, 1e-10);
    const Triangulation& solved = result.intrinsic.triangulation;
    for (Index h = 0; h < solved.num_halfedges(); ++h) {
      longest = std::max(longest, result.log_lengths[solved.edge[h]] -
                                      result.log_lengths[solved.edge[Triangulation::Next(h)]]);
    }
  }
  EXPECT_GT(longest, std::log(1e11));
}

TEST(SolveLogScales, CancelledAndUnsolvableSaySo) {
  const Surface surface = GeneratedSurface("blob", 100);
  const ConeTargets cones = RandomCones(surface, 0.3, 2);
  std::atomic<bool> cancelled = true;
  LogScalesResult result;
  const auto newton = *MakeSolverStrategy("newton");
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  EXPECT_EQ(SolveLogScales(surface.triangulation, lengths, cones, KeptEdges::kBoundary, *newton,
                           {{}, &cancelled}, &result)
                .code(),
            StatusCode::kCancelled);
  const auto one_step = *MakeSolverStrategy("newton", {{"max_iterations", "0"}});
  const Status limited = SolveLogScales(surface.triangulation, lengths, cones, KeptEdges::kBoundary,
                                        *one_step, {}, &result);
  EXPECT_EQ(limited.code(), StatusCode::kNotConverged);
  EXPECT_THAT(limited.message(), HasSubstr("angle sums miss their targets by"));
}

}  // namespace
}  // namespace cirque

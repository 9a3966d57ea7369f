#include "cirque/radii/solve_log_radii.h"

#include <cmath>

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace cirque

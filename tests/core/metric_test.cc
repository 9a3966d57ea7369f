#include "cirque/core/metric.h"

#include <gtest/gtest.h>

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

TEST(GaussBonnet, FlatTargetsMissTwoPiChiOnClosedSurfaces) {
  const std::pair<const char*, int> kTable[] = {
      {"sphere", 2}, {"blob", 2}, {"torus", 0}, {"double_torus", -2}};
  for (const auto& [name, chi] : kTable) {
    SCOPED_TRACE(name);
    const Triangulation t = GeneratedSurface(name, 1000).triangulation;
    ConeTargets targets = FreeBoundaryTargets(t);
    const GaussBonnetDefect defect = MeasureGaussBonnetDefect(t, targets);
    EXPECT_EQ(defect.lower, 2 * kPi * chi);
    EXPECT_EQ(defect.upper, 2 * kPi * chi);
    EXPECT_EQ(defect.IsZeroPossible(1e-9), chi == 0);
    // The missing curvature put on four vertices; then a range about it.
    for (Index v = 0; v < 4; ++v) targets.lower[v] = targets.upper[v] = kPi * (2 - chi / 2.);
    EXPECT_TRUE(MeasureGaussBonnetDefect(t, targets).IsZeroPossible(0));
    targets.lower[0] -= 1;
    targets.upper[0] += 0.5;
    const GaussBonnetDefect ranged = MeasureGaussBonnetDefect(t, targets);
    EXPECT_NEAR(ranged.lower, -1, 1e-12);
    EXPECT_NEAR(ranged.upper, 0.5, 1e-12);
  }
}

TEST(GaussBonnet, FreeBoundariesLeaveRoom) {
  for (const char* name : {"bumpy_terrain", "annulus"}) {
    SCOPED_TRACE(name);
    const Triangulation t = GeneratedSurface(name, 1000).triangulation;
    ConeTargets targets = FreeBoundaryTargets(t);
    const GaussBonnetDefect free = MeasureGaussBonnetDefect(t, targets);
    EXPECT_LT(free.lower, 0);
    EXPECT_GT(free.upper, 0);
    // Straight boundary: what is missing is the boundary's turning, 2 pi chi.
    const std::vector<bool> boundary = BoundaryVertices(t);
    for (Index v = 0; v < t.num_vertices; ++v) {
      if (boundary[v]) targets.lower[v] = targets.upper[v] = kPi;
    }
    const GaussBonnetDefect straight = MeasureGaussBonnetDefect(t, targets);
    EXPECT_EQ(straight.lower, 2 * kPi * EulerCharacteristic(t));
    EXPECT_EQ(straight.upper, straight.lower);
  }
}

TEST(FreeBoundaryTargets, FixTheInsideAndLeaveTheBoundaryAllThatCornersReach) {
  const Triangulation fan = Fan(5, 0.3).triangulation;
  const ConeTargets targets = FreeBoundaryTargets(fan);
  EXPECT_TRUE(targets.IsFixed(0));
  EXPECT_EQ(targets.lower[0], 2 * kPi);
  for (Index v = 1; v <= 5; ++v) {
    EXPECT_FALSE(targets.IsFixed(v));
    EXPECT_EQ(targets.lower[v], 0);
    EXPECT_EQ(targets.upper[v], 2 * kPi);  // two corners
  }
  // Whatever the angles of a disk, they lie within its targets but for the curvature inside.
  const CornerAngles angles = AnglesOf(Fan(5, 0.3));
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(6);
  for (Index h = 0; h < fan.num_halfedges(); ++h) sum[fan.vertex[h]] += angles.value[h];
  for (Index v = 1; v <= 5; ++v) {
    EXPECT_GT(sum[v], targets.lower[v]);
    EXPECT_LT(sum[v], targets.upper[v]);
  }
  EXPECT_LT(sum[0], targets.lower[0]);
}

TEST(GaussBonnet, ManyConesOfAQuarterTurnAddUpExactly) {
  // 2000 pairs of cones of curvature pi/2 and -pi/2: in radians their sum would round.
  const Triangulation t = GeneratedSurface("torus", 10000).triangulation;
  ASSERT_GE(t.num_vertices, 4000);
  ConeTargets targets = FreeBoundaryTargets(t);
  for (Index v = 0; v < 4000; ++v) {
    targets.lower[v] = targets.upper[v] = kPi * (v % 2 ? 1.5 : 2.5);
  }
  EXPECT_EQ(MeasureGaussBonnetDefect(t, targets).lower, 0);
  targets.lower[7] = targets.upper[7] = kPi * (1.5 + 1e-12);
  EXPECT_NEAR(MeasureGaussBonnetDefect(t, targets).lower, 1e-12 * kPi, 1e-13);
}

}  // namespace
}  // namespace cirque

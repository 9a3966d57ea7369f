#include <gtest/gtest.h>

#include "cirque/core/metric.h"

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

}  // namespace
}  // namespace cirque

#include "cirque/layout/planar_layout.h"

#include <gtest/gtest.h>

#include "cirque/metrics/injectivity.h"
#include "cirque/metrics/similarity.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

TEST(PlanarLayout, FlatPatchComesBackUpToARigidMotion) {
  const Surface patch = GeneratedSurface("flat_delaunay_patch", 3000);
  const PlanarLayout layout =
      LayOutByDirections(patch.triangulation, AnglesOf(patch), MeasureEdgeLengths(patch));
  EXPECT_LT(layout.closure, 1e-10);
  std::vector<Eigen::Vector2d> wanted;
  for (const Index v : patch.triangulation.vertex) wanted.push_back(patch.position[v].head<2>());
  const Similarity similarity = FitSimilarity(layout.uv.value, wanted);
  EXPECT_LT(similarity.max_error, 1e-11);
  EXPECT_NEAR(std::abs(similarity.factor), 1, 1e-11);
  EXPECT_TRUE(FlippedFaces(patch.triangulation, layout.uv).empty());
}

TEST(PlanarLayout, ClosureSeesAWrongAngle) {
  const Surface fan = Fan(6, 0.0);
  CornerAngles angles = AnglesOf(fan);
  angles.value[0] += 0.01;
  EXPECT_GT(LayOutByDirections(fan.triangulation, angles, MeasureEdgeLengths(fan)).closure, 1e-3);
}

}  // namespace
}  // namespace cirque

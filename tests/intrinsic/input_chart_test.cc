#include "cirque/intrinsic/input_chart.h"

#include <numeric>

#include <gtest/gtest.h>

#include "cirque/intrinsic/intrinsic_surface.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

TEST(InputChart, UndoneFlipsGiveBackAFlatMetric) {
  // A flat patch keeps its angles through any flips.
  const Surface patch = GeneratedSurface("flat_delaunay_patch", 800);
  const Triangulation& t = patch.triangulation;
  Surface sheared = patch;
  for (Eigen::Vector3d& p : sheared.position) p.x() += 1.5 * p.y();
  const EdgeLengths lengths = MeasureEdgeLengths(sheared);
  const IntrinsicTriangulation intrinsic = MakeIntrinsicDelaunay(t, lengths);
  ASSERT_GT(intrinsic.flips.size(), 100u);
  const CornerAngles flat = MeasureCornerAngles(intrinsic.triangulation, intrinsic.lengths);
  const InputChart back = ReadOnInput(t, intrinsic, flat, intrinsic.lengths);
  EXPECT_TRUE(back.flipped.empty());
  EXPECT_LT((back.lengths.value - lengths.value).lpNorm<Eigen::Infinity>(), 1e-12);
  EXPECT_LT((back.angles.value - AnglesOf(sheared).value).lpNorm<Eigen::Infinity>(), 1e-11);
}

TEST(InputChart, ATriangleThatFoldsOverIsNamedFlipped) {
  // A flat fan whose Delaunay edges are read in another flat metric: its centre pulled across an
  // edge.
  const Surface fan = Fan(5, 0.0);
  IntrinsicTriangulation same = {fan.triangulation, MeasureEdgeLengths(fan), {}, {}};
  CornerAngles angles = AnglesOf(fan);
  EXPECT_TRUE(ReadOnInput(fan.triangulation, same, angles, same.lengths).flipped.empty());
  angles.value.head<3>() *= -1;
  EXPECT_EQ(ReadOnInput(fan.triangulation, same, angles, same.lengths).flipped,
            std::vector<Index>{0});
}

}  // namespace
}  // namespace cirque

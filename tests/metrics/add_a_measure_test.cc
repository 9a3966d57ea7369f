// Follows CONTRIBUTING.md: a distortion measure in one file pair and one line of a table is
// measured and listed like the library's own.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/metrics/measure_map.h"

#include "tests/metrics/example/l2_stretch.h"
#include "tests/metrics/maps.h"

namespace cirque {
namespace {

// ---- its line ----
Registry<DistortionMeasure> MyMeasures() {
  return DistortionMeasures().With("l2_stretch", L2Stretch());
}

double StretchOf(const TestMap& map) {
  return MeasureMap(map.triangulation, map.lengths, map.uv, nullptr, MyMeasures())
      .ValueOf("l2_stretch");
}

TEST(AddAMeasure, ALinearMapHasItsKnownValue) {
  // Singular values 6 and 3/2, 2 and 1/2 once both areas are scaled to 1.
  const TestMap map = MapOf(
      Grid(3, 2), [](const Eigen::Vector3d& p) { return Eigen::Vector2d(6 * p.x(), 1.5 * p.y()); });
  EXPECT_NEAR(StretchOf(map), std::sqrt((4 + 0.25) / 2), 1e-14);
  EXPECT_NEAR(StretchOf(DroppedToPlane(Grid(3, 2))), 1, 1e-14);
}

TEST(AddAMeasure, AnyOtherMapStretchesMore) {
  const TestMap map = MapOf(Grid(3, 2), [](const Eigen::Vector3d& p) {
    return Eigen::Vector2d(p.x() + 0.1 * p.y() * p.y(), p.y());
  });
  EXPECT_GT(StretchOf(map), 1.001);
}

TEST(AddAMeasure, ItIsListedBehindTheOthers) {
  const TestMap map = DroppedToPlane(Grid(2, 2));
  const MapMeasures with =
      MeasureMap(map.triangulation, map.lengths, map.uv, nullptr, MyMeasures());
  EXPECT_EQ(with.figures.size(), map.Measure().figures.size() + 1);
  EXPECT_EQ(with.figures.back().name, "l2_stretch");
  EXPECT_EQ(with.FaceValuesOf("l2_stretch").value.size(), 8);
  EXPECT_THAT(FormatFigures(with), testing::HasSubstr("l2_stretch"));
}

}  // namespace
}  // namespace cirque

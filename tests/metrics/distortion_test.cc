#include "cirque/metrics/distortion.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

DistortionSummary Under(const Surface& s, const Eigen::Matrix2d& map) {
  CornerUv uv;
  for (const Index v : s.triangulation.vertex) {
    uv.value.push_back(map * s.position[v].head<2>() + Eigen::Vector2d(3, -1));
  }
  return Summarize(MeasureDistortion(s.triangulation, MeasureEdgeLengths(s), uv));
}

TEST(Distortion, SimilaritiesAreNeutral) {
  Eigen::Matrix2d similarity;
  similarity << 0.6, -0.8, 0.8, 0.6;
  const DistortionSummary d = Under(GeneratedSurface("flat_delaunay_patch", 300), 250 * similarity);
  EXPECT_NEAR(d.quasi_conformal_mean, 1, 1e-10);
  EXPECT_NEAR(d.quasi_conformal_max, 1, 1e-10);
  EXPECT_NEAR(d.log_area_ratio_l2, 0, 1e-10);
}

TEST(Distortion, AStretchHasItsRatioEverywhere) {
  const DistortionSummary d =
      Under(GeneratedSurface("flat_delaunay_patch", 300), Eigen::Vector2d(3, 0.5).asDiagonal());
  EXPECT_NEAR(d.quasi_conformal_mean, 6, 1e-9);
  EXPECT_NEAR(d.quasi_conformal_max, 6, 1e-9);
  EXPECT_NEAR(d.log_area_ratio_max, 0, 1e-10);
}

TEST(Distortion, ConeOntoItsBaseHasKnownRatios) {
  // An n-fan of height h: each face's altitude from the rim edge grows from a to hypot(a, h).
  const double a = std::cos(kPi / 6), h = 0.7;
  const DistortionSummary d = Under(Fan(6, h), Eigen::Matrix2d::Identity());
  EXPECT_NEAR(d.quasi_conformal_mean, std::hypot(a, h) / a, 1e-12);
  EXPECT_NEAR(d.log_area_ratio_l2, 0, 1e-12);
}

}  // namespace
}  // namespace cirque

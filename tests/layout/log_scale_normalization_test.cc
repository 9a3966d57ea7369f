#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "cirque/layout/moebius_normalization.h"

namespace cirque {
namespace {

using Eigen::Vector3d;

class LogScaleNormalizationTest : public ::testing::Test {
 protected:
  Vector3d RandomUnit() {
    return Vector3d(normal_(random_), normal_(random_), normal_(random_)).normalized();
  }

  /// Random points, edges between random pairs of them, at their own lengths times noise.
  ScaledEdges RandomEdges(const std::vector<Vector3d>& points, int count, double noise) {
    std::uniform_int_distribution<Index> any(0, static_cast<Index>(points.size()) - 1);
    ScaledEdges edges;
    while (static_cast<int>(edges.ends.size()) < count) {
      const Index i = any(random_), j = any(random_);
      if (i == j) continue;
      edges.ends.emplace_back(i, j);
      edges.length.push_back((points[i] - points[j]).norm() * std::exp(noise * normal_(random_)));
      edges.weight.push_back(0.5 + std::abs(normal_(random_)));
    }
    return edges;
  }

  static double Energy(const std::vector<Vector3d>& points, const ScaledEdges& edges) {
    double sum = 0, total = 0;
    for (std::size_t e = 0; e < edges.ends.size(); ++e) {
      const auto& [i, j] = edges.ends[e];
      const double scale = std::log((points[i] - points[j]).norm() / edges.length[e]);
      sum += edges.weight[e] * scale * scale;
      total += edges.weight[e];
    }
    return sum / total;
  }

  static std::vector<Vector3d> Boosted(std::vector<Vector3d> points,
                                       const std::vector<LorentzBoost>& boosts) {
    for (const LorentzBoost& boost : boosts) {
      for (Vector3d& v : points) v = boost(v);
    }
    return points;
  }

  std::mt19937_64 random_{23};
  std::normal_distribution<double> normal_;
};

TEST_F(LogScaleNormalizationTest, UndoesABoost) {
  std::vector<Vector3d> points;
  for (int i = 0; i < 100; ++i) points.push_back(RandomUnit());
  const ScaledEdges edges = RandomEdges(points, 400, 0);
  for (const double far : {0.1, 0.9, 0.999}) {
    const std::vector<Vector3d> moved = Boosted(points, {LorentzBoost(far * RandomUnit())});
    const LogScaleNormalization result = MinimizeLogScale(moved, edges);
    EXPECT_TRUE(result.converged) << far;
    EXPECT_LT(result.value, 1e-20);
    EXPECT_LT(Energy(Boosted(moved, result.boosts), edges), 1e-20);
    EXPECT_LE(result.iterations, 15);
  }
}

TEST_F(LogScaleNormalizationTest, NoBoostNearTheMinimumIsBetter) {
  std::vector<Vector3d> points;
  for (int i = 0; i < 100; ++i) points.push_back(RandomUnit());
  const ScaledEdges edges = RandomEdges(points, 400, 0.7);
  const LogScaleNormalization result = MinimizeLogScale(points, edges);
  ASSERT_TRUE(result.converged);
  const std::vector<Vector3d> best = Boosted(points, result.boosts);
  EXPECT_NEAR(Energy(best, edges), result.value, 1e-13);
  EXPECT_LT(result.value, Energy(points, edges));
  for (const double far : {1e-3, 0.1, 0.5}) {
    for (int trial = 0; trial < 20; ++trial) {
      EXPECT_GT(Energy(Boosted(best, {LorentzBoost(far * RandomUnit())}), edges), result.value);
    }
  }
}

TEST_F(LogScaleNormalizationTest, CoincidentPointsEndInNoNan) {
  const std::vector<Vector3d> points = {{1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const ScaledEdges edges = {{{0, 1}, {1, 2}, {2, 3}, {3, 0}}, {1, 1, 1, 1}, {1, 1, 1, 1}};
  const LogScaleNormalization result = MinimizeLogScale(points, edges);
  EXPECT_TRUE(std::isfinite(result.value));
  EXPECT_TRUE(std::isfinite(result.gradient));
}

}  // namespace
}  // namespace cirque

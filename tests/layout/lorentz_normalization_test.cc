#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "cirque/layout/moebius_normalization.h"

namespace cirque {
namespace {

using Eigen::Vector3d;

class LorentzNormalizationTest : public ::testing::Test {
 protected:
  Vector3d RandomUnit() {
    return Vector3d(normal_(random_), normal_(random_), normal_(random_)).normalized();
  }

  /// n points within about `scale` of one direction.
  std::vector<Vector3d> Crowd(int n, double scale) {
    const Vector3d centre = RandomUnit();
    std::vector<Vector3d> points;
    for (int i = 0; i < n; ++i) points.push_back((centre + scale * RandomUnit()).normalized());
    return points;
  }

  static Vector3d CentreOfMass(const std::vector<Vector3d>& points,
                               const std::vector<double>& weights) {
    Vector3d sum = Vector3d::Zero();
    double total = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      sum += weights[i] * points[i];
      total += weights[i];
    }
    return sum / total;
  }

  std::mt19937_64 random_{11};
  std::normal_distribution<double> normal_;
};

TEST_F(LorentzNormalizationTest, CentresCrowdsOfEveryScaleInTenSteps) {
  SolverLimits limits;
  limits.gradient_tolerance = 1e-15;
  for (double scale = 1; scale > 0.5e-12; scale /= 10) {
    for (int trial = 0; trial < 5; ++trial) {
      const std::vector<Vector3d> points = Crowd(200, scale);
      std::vector<double> weights(points.size());
      for (double& w : weights) w = trial == 0 ? 1 : 0.1 + std::abs(normal_(random_));
      const LorentzNormalization result = MinimizeLorentz(points, weights, limits);
      EXPECT_LT(CentreOfMass(result.points, weights).norm(), 1e-14)
          << scale << " " << result.summary.FullReport();
      EXPECT_LE(result.summary.num_iterations(), 10) << scale << result.summary.FullReport();
      for (const Vector3d& v : result.points) EXPECT_NEAR(v.norm(), 1, 1e-15);
    }
  }
}

TEST_F(LorentzNormalizationTest, BoostsCarryOtherPointsAlong) {
  const std::vector<Vector3d> points = Crowd(50, 1e-3);
  const LorentzNormalization result = MinimizeLorentz(points, std::vector<double>(50, 1.0));
  ASSERT_TRUE(result.summary.Converged()) << result.summary.message;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Vector3d v = points[i];
    for (const LorentzBoost& boost : result.boosts) v = boost(v);
    EXPECT_LT((v - result.points[i]).norm(), 1e-11);
  }
}

TEST_F(LorentzNormalizationTest, TwoCrowdsOfUnequalWeightMeetInTheMiddle) {
  // A boost along the axis balances them; their midpoint lies off the axis only by their spread.
  std::vector<Vector3d> points;
  for (int i = 0; i < 90; ++i) points.push_back((Vector3d(0, 0, 1) + 1e-4 * RandomUnit()));
  for (int i = 0; i < 10; ++i) points.push_back((Vector3d(0, 0, -1) + 1e-4 * RandomUnit()));
  for (Vector3d& v : points) v.normalize();
  const std::vector<double> weights(points.size(), 2.5);
  const LorentzNormalization result = MinimizeLorentz(points, weights);
  EXPECT_TRUE(result.summary.Converged()) << result.summary.FullReport();
  EXPECT_LT(CentreOfMass(result.points, weights).norm(), 1e-11);
  EXPECT_LE(result.summary.num_iterations(), 10);
}

TEST_F(LorentzNormalizationTest, RefusesWhatHasNoMinimum) {
  const std::vector<Vector3d> points = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto message = [&](const std::vector<Vector3d>& p, const std::vector<double>& w) {
    const LorentzNormalization result = MinimizeLorentz(p, w);
    EXPECT_EQ(result.summary.termination, Termination::kInvalidStart);
    EXPECT_FALSE(result.summary.x_changed);
    return result.summary.message;
  };
  EXPECT_EQ(message(points, {1, 2, 1}),
            "point 1 has at least half of all weight: no boost centres it");
  EXPECT_EQ(message(points, {1, 1}), "3 points but 2 weights");
  EXPECT_EQ(message(points, {1, -1, 1}), "the weight of point 1 is -1, not positive");
  EXPECT_EQ(message({{2, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {1, 1, 1}),
            "point 0 is no unit vector: its length is 2");
  EXPECT_EQ(message({}, {}), "there is no point to centre");
}

TEST_F(LorentzNormalizationTest, CoincidentPointsOfHalfTheWeightEndAtTheLimitNotInNan) {
  const std::vector<Vector3d> points = {{1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  SolverLimits limits;
  limits.max_iterations = 30;
  const LorentzNormalization result = MinimizeLorentz(points, {1, 1, 1, 0.5}, limits);
  EXPECT_FALSE(result.summary.Converged());
  for (const Vector3d& v : result.points) EXPECT_TRUE(v.allFinite());
}

}  // namespace
}  // namespace cirque

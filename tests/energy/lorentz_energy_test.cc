#include "cirque/energy/lorentz_energy.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "cirque/math/moebius.h"

namespace cirque {
namespace {

using Eigen::Vector3d;

class LorentzEnergyTest : public ::testing::Test {
 protected:
  Vector3d RandomUnit() {
    return Vector3d(normal_(random_), normal_(random_), normal_(random_)).normalized();
  }

  double Value(const std::vector<Vector3d>& points, const Vector3d& x) {
    const std::vector<double> weights(points.size(), 1.0);
    double value = std::nan("");
    EXPECT_TRUE(LorentzEnergy(points, weights).Evaluate(x.data(), &value, nullptr));
    return value;
  }

  std::mt19937_64 random_{3};
  std::normal_distribution<double> normal_;
};

TEST_F(LorentzEnergyTest, OnePointIsItsBusemannFunction) {
  // Straight out to v the energy falls by the hyperbolic distance gone, atanh |x|.
  const Vector3d v = RandomUnit();
  for (const double r : {-0.9, -0.1, 1e-9, 0.3, 0.999}) {
    EXPECT_NEAR(Value({v}, r * v), -std::atanh(r), 1e-13);
  }
}

TEST_F(LorentzEnergyTest, CentredPointsHaveTheirMinimumAtTheCentre) {
  const std::vector<Vector3d> octahedron = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                            {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
  const std::vector<double> weights(6, 1.0);
  const LorentzJet jet = LorentzEnergy(octahedron, weights).Jet(Vector3d::Zero());
  EXPECT_EQ(jet.value, 0);
  EXPECT_EQ(jet.slope.norm(), 0);
  EXPECT_LT((jet.curvature - 4 * Eigen::Matrix3d::Identity()).norm(), 1e-15);
  for (int i = 0; i < 20; ++i) EXPECT_GT(Value(octahedron, 0.9 * RandomUnit()), 0.1);
}

TEST_F(LorentzEnergyTest, BoostingMovesTheEnergyRigidly) {
  // S of the boosted points at 0 differs from S at x by a constant: differences agree.
  std::vector<Vector3d> points;
  for (int i = 0; i < 20; ++i) points.push_back(RandomUnit());
  const Vector3d x = 0.7 * RandomUnit();
  const LorentzBoost boost(x);
  std::vector<Vector3d> boosted;
  for (const Vector3d& v : points) boosted.push_back(boost(v));
  // The boost carries (s + x)/(1 + s) along the ray of x back to s.
  const double s = 0.4, r = x.norm();
  const Vector3d ahead = (s + r) / (1 + s * r) * x / r;
  EXPECT_NEAR(Value(points, ahead) - Value(points, x), Value(boosted, s * x / r), 1e-13);
  EXPECT_GT(std::abs(Value(boosted, s * x / r)), 1e-3);
}

TEST_F(LorentzEnergyTest, IsConvexAlongGeodesicsButNotInTheBall) {
  const std::vector<Vector3d> points = {RandomUnit(), RandomUnit(), RandomUnit(), RandomUnit()};
  for (int trial = 0; trial < 100; ++trial) {
    // Every geodesic is the boosted image of a diameter.
    const LorentzBoost boost(0.95 * RandomUnit());
    std::vector<Vector3d> boosted;
    for (const Vector3d& v : points) boosted.push_back(boost(v));
    const Vector3d u = RandomUnit();
    const double t = 2 * normal_(random_), h = 0.1;
    const double bend = Value(boosted, std::tanh(t + h) * u) +
                        Value(boosted, std::tanh(t - h) * u) - 2 * Value(boosted, std::tanh(t) * u);
    EXPECT_GE(bend, -1e-13);
  }
  const Vector3d v = points[0];
  EXPECT_LT(Value({v}, 0.9 * v) + Value({v}, 0.7 * v) - 2 * Value({v}, 0.8 * v), -0.01);
  const std::vector<double> weights(points.size(), 1.0);
  EXPECT_FALSE(LorentzEnergy(points, weights).IsConvex());
}

}  // namespace
}  // namespace cirque

#include "cirque/energy/circle_pattern_energy.h"

#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "cirque/angles/registry.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

/// A bumpy disk with coherent angles, and log radii off its minimum.
class CirclePatternEnergyTest : public ::testing::Test {
 protected:
  CirclePatternEnergyTest() {
    const AngleConstraints constraints(t(), targets_);
    AngleFitResult fit;
    const CornerAngles reference = AnglesOf(surface_);
    const auto newton = *MakeAngleSolver("newton");
    const Status status = FitAngles({constraints, reference.value, 1e-3},
                                    *AngleObjectives().Find("quadratic"), *newton, {}, &fit);
    EXPECT_TRUE(status.ok()) << status.message();
    angles_ = fit.angles;
    std::mt19937 random(7);
    rho_.resize(t().num_faces());
    for (double& r : rho_) r = std::ldexp(static_cast<double>(random()), -31) - 1;
  }

  const Triangulation& t() const { return surface_.triangulation; }

  const Surface surface_ = GeneratedSurface("bumpy_terrain", 200);
  const ConeTargets targets_ = FreeBoundaryTargets(surface_.triangulation);
  CoherentAngles angles_;
  Eigen::VectorXd rho_;
};

TEST_F(CirclePatternEnergyTest, GradientIsTheTaylorTermOfTheValue) {
  const CirclePatternEnergy energy(t(), angles_);
  Eigen::VectorXd gradient(rho_.size());
  double value;
  ASSERT_TRUE(energy.Evaluate(rho_.data(), &value, gradient.data()));
  const Eigen::VectorXd p = Eigen::VectorXd::Random(rho_.size()).normalized();
  double last_error = 0;
  for (const double h : {1e-1, 1e-2, 1e-3}) {
    const Eigen::VectorXd x = rho_ + h * p;
    double moved;
    ASSERT_TRUE(energy.Evaluate(x.data(), &moved, nullptr));
    const double error = std::abs(moved - value - h * gradient.dot(p));
    if (last_error > 0) {
      EXPECT_NEAR(error / last_error, 1e-2, 2e-3);  // second order
    }
    last_error = error;
  }
}

TEST_F(CirclePatternEnergyTest, HessianIsTheGradientsDerivativeAndPositiveBesidesTheGauge) {
  const CirclePatternEnergy energy(t(), angles_);
  SparseMatrix lower;
  ASSERT_TRUE(energy.Hessian(rho_.data(), &lower));
  const Eigen::MatrixXd hessian = SparseMatrix(lower.selfadjointView<Eigen::Lower>());
  const double h = 1e-5;
  for (int f = 0; f < rho_.size(); f += 17) {
    Eigen::VectorXd plus = rho_, minus = rho_, gp(rho_.size()), gm(rho_.size());
    plus[f] += h;
    minus[f] -= h;
    energy.Gradient(plus.data(), gp.data());
    energy.Gradient(minus.data(), gm.data());
    EXPECT_LT(((gp - gm) / (2 * h) - hessian.col(f)).lpNorm<Eigen::Infinity>(), 1e-8);
  }
  const Eigen::VectorXd eigenvalues =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(hessian).eigenvalues();
  EXPECT_NEAR(eigenvalues[0], 0, 1e-12);
  EXPECT_GT(eigenvalues[1], 1e-6);
}

TEST_F(CirclePatternEnergyTest, ScaleIsAGauge) {
  const CirclePatternEnergy energy(t(), angles_);
  const Eigen::VectorXd scaled = rho_.array() + 3.5;
  double value, scaled_value;
  Eigen::VectorXd gradient(rho_.size()), scaled_gradient(rho_.size());
  energy.Evaluate(rho_.data(), &value, gradient.data());
  energy.Evaluate(scaled.data(), &scaled_value, scaled_gradient.data());
  EXPECT_NEAR(value, scaled_value, 1e-11 * std::abs(value));
  EXPECT_LT((gradient - scaled_gradient).lpNorm<Eigen::Infinity>(), 1e-13);
  EXPECT_NEAR(gradient.sum(), 0, 1e-11);
}

TEST_F(CirclePatternEnergyTest, ResidualsAreTheEnergyUpToItsOffset) {
  const CirclePatternEnergy energy(t(), angles_);
  Eigen::VectorXd x = rho_, gradient(rho_.size());
  double value, cost;
  energy.Evaluate(x.data(), &value, gradient.data());
  ceres::Problem problem;
  energy.AddResidualBlocks(x.data(), &problem);
  std::vector<double> problem_gradient;
  problem.Evaluate({}, &cost, nullptr, &problem_gradient, nullptr);
  EXPECT_NEAR(cost, value - energy.ResidualOffset(), 1e-11 * std::abs(value));
  // The gauge parameter is constant: its entry is zero.
  const Eigen::Map<Eigen::VectorXd> given(problem_gradient.data(), problem_gradient.size());
  ASSERT_EQ(given.size(), gradient.size());
  EXPECT_EQ(given[0], 0);
  EXPECT_LT((given - gradient).tail(gradient.size() - 1).lpNorm<Eigen::Infinity>(), 1e-11);
}

}  // namespace
}  // namespace cirque

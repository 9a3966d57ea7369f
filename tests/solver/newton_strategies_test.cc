// Newton's method and its preconditioned relative on functions whose minimum is known.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/solver/strategy_fixtures.h"

namespace cirque {
namespace {

/// sum e^x_i - x_i: a Newton step from x ends at x^2 / 2.
class ExponentialEnergy final : public Energy {
 public:
  int NumParameters() const override { return 3; }
  bool Evaluate(const double* x, double* value, double* gradient) const override {
    *value = 0;
    for (int i = 0; i < 3; ++i) {
      *value += std::expm1(x[i]) - x[i];
      if (gradient) gradient[i] = std::expm1(x[i]);
    }
    return std::isfinite(*value);
  }
  bool Hessian(const double* x, SparseMatrix* lower) const override {
    lower->resize(3, 3);
    lower->setIdentity();
    for (int i = 0; i < 3; ++i) lower->coeffRef(i, i) = std::exp(x[i]);
    return true;
  }
};

class NewtonStrategies : public ::testing::TestWithParam<std::string> {};

TEST_P(NewtonStrategies, OneStepSolvesAQuadratic) {
  const QuadraticEnergy energy(Eigen::VectorXd::LinSpaced(40, -3, 7));
  Eigen::VectorXd x = Eigen::VectorXd::Zero(40);
  const SolveSummary summary = Strategy(GetParam())->Minimize(energy, {}, &x);
  EXPECT_TRUE(summary.Converged()) << summary.FullReport();
  EXPECT_EQ(summary.num_iterations(), 1);
  EXPECT_EQ(summary.factorizations, 1);
  EXPECT_LT((x - energy.minimiser()).lpNorm<Eigen::Infinity>(), 1e-13);
  EXPECT_LT(summary.final_value, 1e-20);
}

TEST_P(NewtonStrategies, TheLastStepGoesByTheLastHessianWhereThatEndsAsLow) {
  // From 0.5 the gradient is 5.5e-3, 1.5e-5, 1.1e-10, and by the last Hessian about 1.6e-15.
  Eigen::VectorXd x = Eigen::VectorXd::Constant(3, 0.5);
  const SolveSummary summary = Strategy(GetParam())->Minimize(ExponentialEnergy(), {}, &x);
  EXPECT_TRUE(summary.Converged()) << summary.FullReport();
  EXPECT_EQ(summary.num_iterations(), 5);
  EXPECT_EQ(summary.hessian_evaluations, 4);
  EXPECT_LT(summary.final_gradient_max, 1e-14);
  EXPECT_LT(x.lpNorm<Eigen::Infinity>(), 1e-14);
}

TEST_P(NewtonStrategies, ATighterToleranceAsksForTheHessianOfEveryStep) {
  Eigen::VectorXd x = Eigen::VectorXd::Constant(3, 0.5);
  const auto strategy = MakeSolverStrategy(GetParam(), {{"gradient_tolerance", "1e-15"}});
  const SolveSummary summary = (*strategy)->Minimize(ExponentialEnergy(), {}, &x);
  EXPECT_TRUE(summary.Converged()) << summary.FullReport();
  EXPECT_EQ(summary.num_iterations(), 5);
  EXPECT_EQ(summary.hessian_evaluations, 5);
  EXPECT_LT(x.lpNorm<Eigen::Infinity>(), 1e-15);
}

TEST_P(NewtonStrategies, HardSaturationBeforeAWallIsNoTrap) {
  // The slope is sigmoid - 1/2 within 1e-6 of zero: from 0.9 plain Newton would step to -1e5 or
  // leave the domain.
  const WallEnergy energy(0, 1e-3, 1e-9);
  for (const double start : {-30.0, -0.5, 0.5, 0.9, 1 - 1e-9}) {
    Eigen::VectorXd x = Eigen::VectorXd::Constant(1, start);
    const SolveSummary summary = Strategy(GetParam())->Minimize(energy, {}, &x);
    EXPECT_TRUE(summary.Converged()) << start << "\n" << summary.FullReport();
    EXPECT_NEAR(x[0], -4e-12, 1e-13);
  }
}

TEST_P(NewtonStrategies, AStartBehindTheWallIsInvalid) {
  const WallEnergy energy(0, 1e-3, 1e-9);
  Eigen::VectorXd x = Eigen::VectorXd::Constant(1, 1.5);
  const SolveSummary summary = Strategy(GetParam())->Minimize(energy, {}, &x);
  EXPECT_EQ(summary.termination, Termination::kInvalidStart);
  EXPECT_EQ(x[0], 1.5);
  EXPECT_TRUE(std::isnan(summary.final_value));
}

TEST_P(NewtonStrategies, LinearSolverIsChosenByName) {
  const auto strategy = MakeSolverStrategy(GetParam(), {{"linear_solver", "lapack"}});
  ASSERT_FALSE(strategy.ok());
  EXPECT_EQ(strategy.status().message().find(GetParam() + ": linear_solver = 'lapack' is not one"),
            0u)
      << strategy.status().message();
  EXPECT_TRUE(MakeSolverStrategy(GetParam(), {{"linear_solver", "eigen"}}).ok());
}

INSTANTIATE_TEST_SUITE_P(Both, NewtonStrategies, ::testing::Values("newton", "newton_cg"),
                         [](const auto& instance) { return instance.param; });

TEST(NewtonCg, OptionsAreBounded) {
  EXPECT_EQ(MakeSolverStrategy("newton_cg", {{"forcing", "1"}}).status().message(),
            "newton_cg: forcing = '1' is not a number in [1e-10, 0.9]");
  EXPECT_EQ(MakeSolverStrategy("newton_cg", {{"max_cg_iterations", "0"}}).status().message(),
            "newton_cg: max_cg_iterations = '0' is not an integer in [1, 1e+06]");
}

}  // namespace
}  // namespace cirque

#include <gtest/gtest.h>

#include "cirque/energy/dual_laplacian.h"
#include "cirque/linear/registry.h"
#include "cirque/solver/newton_loop.h"

#include "tests/solver/strategy_fixtures.h"

namespace cirque {
namespace {

/// sum over i of s(x_i - x_{i+1} - t_i) with s(d) = d^2 / 2 (gauge: a constant), or
/// sum of max(0, |x_i| - 1)^2 / 2, whose generalised Hessian is zero in the box.
class ChainEnergy final : public Energy {
 public:
  explicit ChainEnergy(int n) : n_(n) {}
  int NumParameters() const override { return n_; }

  bool Evaluate(const double* x, double* value, double* gradient) const override {
    *value = 0;
    if (gradient) std::fill_n(gradient, n_, 0.0);
    for (int i = 0; i + 1 < n_; ++i) {
      const double d = x[i] - x[i + 1] - i;
      *value += 0.5 * d * d;
      if (gradient) gradient[i] += d, gradient[i + 1] -= d;
    }
    return true;
  }

  bool Hessian(const double*, SparseMatrix* lower) const override {
    LaplacianAssembler laplacian(n_, n_ - 1);
    for (int i = 0; i + 1 < n_; ++i) laplacian.Add(i, i + 1, 1);
    laplacian.Assemble(lower);
    return true;
  }

  std::vector<int> GaugeParameters() const override { return {2}; }

 private:
  int n_;
};

/// sum (max(0, |x_i| - 1))^2 / 2: its generalised Hessian vanishes where |x_i| <= 1.
class BoxEnergy final : public Energy {
 public:
  int NumParameters() const override { return 2; }

  bool Evaluate(const double* x, double* value, double* gradient) const override {
    *value = 0;
    for (int i = 0; i < 2; ++i) {
      const double excess = std::max(0.0, std::abs(x[i]) - 1);
      *value += 0.5 * excess * excess;
      if (gradient) gradient[i] = std::copysign(excess, x[i]);
    }
    return true;
  }

  bool Hessian(const double* x, SparseMatrix* lower) const override {
    lower->resize(2, 2);
    for (int i = 0; i < 2; ++i) lower->insert(i, i) = std::abs(x[i]) > 1 ? 1 : 0;
    lower->makeCompressed();
    return true;
  }

  double LeastDamping() const override { return 1e-9; }
};

TEST(LevenbergMarquardtDamping, StepLeavesTheGaugeParameterAlone) {
  const ChainEnergy energy(5);
  LevenbergMarquardtDamping damping(energy);
  const Eigen::VectorXd x = Eigen::VectorXd::Random(5);
  Eigen::VectorXd gradient(5);
  energy.Gradient(x.data(), gradient.data());
  SparseMatrix lower;
  energy.Hessian(x.data(), &lower);
  const auto cholesky = MakeCholesky();
  damping.DampHessian(&lower);
  ASSERT_TRUE(cholesky->Factorize(lower));
  const Eigen::VectorXd step = -cholesky->Solve(gradient);
  EXPECT_NEAR(step[2], 0, 1e-14);
  EXPECT_GT(step.norm(), 0.1);
  // And it is a Newton step: the minimum of this quadratic.
  const Eigen::VectorXd moved = x + step;
  energy.Gradient(moved.data(), gradient.data());
  EXPECT_LT(gradient.lpNorm<Eigen::Infinity>(), 1e-14);
}

TEST(LevenbergMarquardtDamping, EveryNewtonStrategyKeepsTheGauge) {
  const ChainEnergy energy(30);
  for (const char* name : {"newton", "newton_cg"}) {
    Eigen::VectorXd x = Eigen::VectorXd::Constant(30, 0.25);
    const SolveSummary summary = Strategy(name)->Minimize(energy, {}, &x);
    EXPECT_TRUE(summary.Converged()) << summary.BriefReport();
    EXPECT_NEAR(x[2], 0.25, 1e-12);
    EXPECT_NEAR(x[0] - x[29], 28 * 29 / 2.0, 1e-10);
  }
}

TEST(LevenbergMarquardtDamping, SingularSemiSmoothHessiansAreNoObstacle) {
  const BoxEnergy energy;
  for (const char* name : {"newton", "newton_cg"}) {
    Eigen::VectorXd x(2);
    x << 7, 0.5;
    const SolveSummary summary = Strategy(name)->Minimize(energy, {}, &x);
    EXPECT_TRUE(summary.Converged()) << summary.FullReport();
    EXPECT_NEAR(x[0], 1, 1e-10);
    EXPECT_EQ(x[1], 0.5);
  }
}

// Raising it again and again leaves no trace of the smaller dampings.
TEST(LevenbergMarquardtDamping, IsRaisedOnTheHessianAsItWas) {
  const ChainEnergy energy(5);
  SparseMatrix lower;
  energy.Hessian(Eigen::VectorXd::Random(5).eval().data(), &lower);
  const SparseMatrix before = lower;
  LevenbergMarquardtDamping damping(energy);
  damping.DampHessian(&lower);
  while (damping.damping() < 1e3) ASSERT_TRUE(damping.Raise(&lower));
  for (int i = 0; i < 5; ++i) {
    const double wanted = before.coeff(i, i) + damping.damping();
    EXPECT_EQ(lower.coeff(i, i), i == 2 ? 2 * wanted : wanted);
  }
  EXPECT_EQ(lower.coeff(1, 0), before.coeff(1, 0));
}

TEST(LevenbergMarquardtDamping, RaisesOnShortStepsAndLowersAfterFullOnes) {
  const BoxEnergy energy;
  LevenbergMarquardtDamping damping(energy);
  EXPECT_EQ(damping.damping(), 1e-9);
  damping.Adapt(0.5);
  EXPECT_EQ(damping.damping(), 1e-9);
  damping.Adapt(0.001);
  EXPECT_EQ(damping.damping(), 1e-5);
  damping.Adapt(0.001);
  EXPECT_NEAR(damping.damping(), 1e-3, 1e-18);
  damping.Adapt(1);
  EXPECT_NEAR(damping.damping(), 1e-5, 1e-18);
  for (int i = 0; i < 9; ++i) damping.Adapt(1);
  EXPECT_EQ(damping.damping(), 1e-9);
  int raises = 0;
  while (damping.Raise()) ++raises;
  EXPECT_GT(raises, 5);
  EXPECT_LT(raises, 12);
}

}  // namespace
}  // namespace cirque

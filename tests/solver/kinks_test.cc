// Energies with kinks, whose minimisers are known in closed form.
#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "cirque/solver/solve_run.h"
#include "cirque/solver/solver_strategy.h"

namespace cirque {
namespace {

/// sum_i 1/2 (x_i - a_i)^2 + c sum_i |x_i|. Its minimiser is soft
/// thresholding: sign(a_i) max(|a_i| - c, 0).
class SoftThreshold final : public Energy {
 public:
  SoftThreshold(Eigen::VectorXd a, double c) : a_(std::move(a)), c_(c) {}

  int NumParameters() const override { return static_cast<int>(a_.size()); }

  bool Evaluate(const double* x, double* value, double* gradient) const override {
    *value = 0;
    for (int i = 0; i < a_.size(); ++i) {
      const double from = x[i] - a_[i];
      *value += 0.5 * from * from + c_ * std::abs(x[i]);
      if (gradient) gradient[i] = from + (x[i] > 0 ? c_ : -c_);
    }
    return true;
  }

  bool Hessian(const double*, SparseMatrix* lower) const override {
    lower->resize(a_.size(), a_.size());
    lower->setIdentity();
    return true;
  }

  std::vector<Kink> Kinks() const override {
    std::vector<Kink> kinks;
    for (int i = 0; i < a_.size(); ++i) kinks.push_back({i, 2 * c_});
    return kinks;
  }

  Eigen::VectorXd Minimiser() const {
    return a_.unaryExpr(
        [this](double a) { return std::copysign(std::max(std::abs(a) - c_, 0.0), a); });
  }

 private:
  const Eigen::VectorXd a_;
  const double c_;
};

TEST(Kinks, BothNewtonStrategiesFindTheSoftThreshold) {
  const Eigen::VectorXd a = Eigen::VectorXd::LinSpaced(41, -2, 2);
  const SoftThreshold energy(a, 0.7);
  for (const char* name : {"newton", "newton_cg"}) {
    for (const double start : {0.0, 3.0, -3.0}) {
      Eigen::VectorXd x = Eigen::VectorXd::Constant(a.size(), start);
      const SolveSummary solve = (*MakeSolverStrategy(name))->Minimize(energy, {}, &x);
      EXPECT_TRUE(solve.Converged()) << name << ": " << solve.message;
      EXPECT_LT((x - energy.Minimiser()).lpNorm<Eigen::Infinity>(), 1e-14) << name;
      EXPECT_EQ((x.array() == 0).count(), (energy.Minimiser().array() == 0).count()) << name;
    }
  }
}

TEST(Kinks, OtherStrategiesRefuseThem) {
  const SoftThreshold energy(Eigen::VectorXd::Ones(3), 0.5);
  for (const char* name : {"ceres_line_search", "ceres_trust_region"}) {
    Eigen::VectorXd x = Eigen::VectorXd::Constant(3, 2.);
    const SolveSummary solve = (*MakeSolverStrategy(name))->Minimize(energy, {}, &x);
    EXPECT_EQ(solve.termination, Termination::kUnsupported) << name;
    EXPECT_EQ(x, Eigen::VectorXd::Constant(3, 2.)) << name;
  }
}

TEST(Kinks, TheSubgradientOfLeastNormKnowsBothSides) {
  const Kinks kinks(SoftThreshold(Eigen::VectorXd::Zero(4), 1));
  Eigen::VectorXd x(4), slope(4), expected(4);
  x << 0, 0, 0, 5;
  slope << 0.5, -0.5, -2.5, 4;  // from below; from above 2 more
  expected << 0.5, 0, -0.5, 4;
  kinks.TakeLeastSubgradient(x, &slope);
  EXPECT_EQ(slope, expected);
}

}  // namespace
}  // namespace cirque

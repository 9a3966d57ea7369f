#include "cirque/linear/lagged_factorization.h"

#include <cmath>

#include <gtest/gtest.h>

#include "cirque/linear/registry.h"
#include "cirque/solver/newton_strategies.h"

#include "tests/linear/grid_matrix.h"

namespace cirque {
namespace {

/// A path's Laplacian with these edge weights, grounded at node 0.
SparseMatrix PathMatrix(const Eigen::VectorXd& weight) {
  const int n = static_cast<int>(weight.size());
  std::vector<Eigen::Triplet<double>> entries = {{0, 0, 1}};
  for (int i = 0; i + 1 < n; ++i) {
    entries.emplace_back(i, i, weight[i]);
    entries.emplace_back(i + 1, i + 1, weight[i]);
    entries.emplace_back(i + 1, i, -weight[i]);
  }
  SparseMatrix lower(n, n);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

class LaggedFactorizationTest : public ::testing::Test {
 protected:
  /// |A x - b| / |b| of a solve with these weights.
  double Residual(const Eigen::VectorXd& weight, double tolerance) {
    return ResidualOf(PathMatrix(weight), {tolerance});
  }

  /// The same of any system.
  double ResidualOf(const SparseMatrix& lower, const SolveAccuracy& accuracy) {
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(lower.cols(), 1, 3);
    Eigen::VectorXd x;
    EXPECT_TRUE(factor_.Solve(lower, b, accuracy, &x, &summary_));
    return (lower.selfadjointView<Eigen::Lower>() * x - b).norm() / b.norm();
  }

  LaggedFactorization factor_{MakeCholesky(), 6};
  SolveSummary summary_;
  const Eigen::VectorXd ones_ = Eigen::VectorXd::Ones(50);
};

TEST_F(LaggedFactorizationTest, SmallChangesTakeIterationsNotFactors) {
  EXPECT_LT(Residual(ones_, 1e-10), 1e-10);
  EXPECT_EQ(summary_.factorizations, 1);
  EXPECT_LT(Residual(1.01 * ones_ + 0.01 * Eigen::VectorXd::LinSpaced(50, -1, 1), 1e-8), 1e-8);
  EXPECT_EQ(summary_.factorizations, 1);
  EXPECT_GT(summary_.cg_iterations, 1);
}

TEST_F(LaggedFactorizationTest, LargeChangesAreFactoredAnew) {
  EXPECT_LT(Residual(ones_, 1e-10), 1e-10);
  const Eigen::VectorXd wild = Eigen::VectorXd::LinSpaced(50, -4, 4).array().exp();
  EXPECT_LT(Residual(wild, 1e-8), 1e-8);
  EXPECT_EQ(summary_.factorizations, 2);
  EXPECT_EQ(summary_.symbolic_analyses, 1);
}

TEST_F(LaggedFactorizationTest, AFewStrongChangesTakeIterationsNotFactors) {
  Eigen::VectorXd weight = Eigen::VectorXd::Ones(400);
  EXPECT_LT(Residual(weight, 1e-10), 1e-10);
  const int before = summary_.cg_iterations;
  weight[100] = 50;
  weight[200] = 20;
  weight[300] = 1e3;
  EXPECT_LT(Residual(weight, 1e-3), 1e-3);
  EXPECT_EQ(summary_.factorizations, 1);
  EXPECT_GT(summary_.cg_iterations, before + 1);
}

TEST_F(LaggedFactorizationTest, MoreStrongChangesThanIterationsTakeNoFactor) {
  // Ten different changes are ten eigenvalues apart: the factor alone would need eleven iterations.
  constexpr int kSide = 40;
  SparseMatrix grid = GridMatrix(kSide, 1e-3);
  EXPECT_LT(ResidualOf(grid, {1e-10}), 1e-10);
  double more = 2;
  for (int k = 0; k < 10; ++k, more *= 1.6) {
    const int i = (3 + 3 * k) * kSide + 3 * k;
    grid.coeffRef(i, i) += more;
    grid.coeffRef(i + 1, i + 1) += more;
    grid.coeffRef(i + 1, i) -= more;
  }
  EXPECT_LT(ResidualOf(grid, {1e-6}), 1e-6);
  EXPECT_EQ(summary_.factorizations, 1);
}

TEST_F(LaggedFactorizationTest, AFactorIsMadeWhereTheWayIsLong) {
  const SparseMatrix grid = GridMatrix(40, 1e-3), other = GridMatrix(40, 1e-3, 1);
  for (const double goal : {1e-1, 1e-10}) {
    LaggedFactorization factor(MakeCholesky(), 6);
    SolveSummary summary;
    Eigen::VectorXd x;
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(grid.cols(), 1, 3);
    for (const SparseMatrix* lower : {&grid, &other}) {
      EXPECT_TRUE(factor.Solve(*lower, b, {1e-1, goal}, &x, &summary));
      EXPECT_EQ(summary.factorizations, 1) << "how well the factor fits is not known yet";
    }
    // The first system, on its own factor, takes none.
    EXPECT_GT(summary.cg_iterations, 2);
    EXPECT_TRUE(factor.Solve(other, b, {1e-1, goal}, &x, &summary));
    EXPECT_EQ(summary.factorizations, goal < 1e-1 ? 2 : 1) << goal;
  }
}

TEST_F(LaggedFactorizationTest, AnIndefiniteMatrixIsRefused) {
  Eigen::VectorXd x;
  EXPECT_FALSE(factor_.Solve(PathMatrix(-ones_), ones_, {1e-8}, &x, &summary_));
}

/// sum_i cosh(x_i - i): minimal at x_i = i.
class Coshes final : public Energy {
 public:
  int NumParameters() const override { return 5; }
  bool Evaluate(const double* x, double* value, double* gradient) const override {
    *value = 0;
    for (int i = 0; i < 5; ++i) {
      *value += std::cosh(x[i] - i);
      if (gradient) gradient[i] = std::sinh(x[i] - i);
    }
    return true;
  }
  bool Hessian(const double* x, SparseMatrix* lower) const override {
    lower->resize(5, 5);
    lower->setIdentity();
    for (int i = 0; i < 5; ++i) lower->coeffRef(i, i) = std::cosh(x[i] - i);
    return true;
  }
};

TEST(AutoStrategy, SaysWhatItChoseAndWhy) {
  const AutoStrategy strategy{SolverLimits()};
  LaggedFactorization factor(MakeCholesky(), 6);
  for (LaggedFactorization* given : {static_cast<LaggedFactorization*>(nullptr), &factor}) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(5);
    SolveControl control;
    control.system_solver = given;
    const SolveSummary summary = strategy.Minimize(Coshes(), control, &x);
    EXPECT_TRUE(summary.Converged()) << summary.message;
    EXPECT_LT((x - Eigen::VectorXd::LinSpaced(5, 0, 4)).norm(), 1e-10);
    EXPECT_TRUE(
        summary.strategy.starts_with(given ? "auto: newton_cg, for " : "auto: newton, for "))
        << summary.strategy;
  }
}

}  // namespace
}  // namespace cirque

#include "cirque/linear/conjugate_gradients.h"

#include <functional>

#include <gtest/gtest.h>

#include "cirque/linear/registry.h"

#include "tests/linear/grid_matrix.h"

namespace cirque {
namespace {

using Eigen::VectorXd;

constexpr int kSide = 30;

void Identity(const VectorXd& b, VectorXd* x) { *x = b; }

SparseMatrix DiagonalMatrix(const VectorXd& entries) {
  SparseMatrix lower(entries.size(), entries.size());
  for (int i = 0; i < entries.size(); ++i) lower.insert(i, i) = entries[i];
  lower.makeCompressed();
  return lower;
}

class ConjugateGradientsTest : public ::testing::Test {
 protected:
  CgResult Solve(const SparseMatrix& lower, const VectorXd& b, double tolerance,
                 int max_iterations) {
    applications_ = 0;
    const auto counted = [this](const VectorXd& v, VectorXd* x) {
      ++applications_;
      precondition_(v, x);
    };
    return ConjugateGradients(lower, b, counted, tolerance, max_iterations, &x_);
  }

  /// |A x - b| / |b|.
  double Residual(const SparseMatrix& lower, const VectorXd& b) const {
    return (lower.selfadjointView<Eigen::Lower>() * x_ - b).norm() / b.norm();
  }

  Preconditioner precondition_ = Identity;
  int applications_ = 0;
  VectorXd x_;
  const SparseMatrix grid_ = GridMatrix(kSide, 0.5, 0.5);
  const VectorXd b_ = VectorXd::LinSpaced(kSide * kSide, 1, 3);
};

TEST_F(ConjugateGradientsTest, AnExactFactorIsAppliedOnce) {
  const auto cholesky = MakeCholesky();
  ASSERT_TRUE(cholesky->Factorize(grid_));
  precondition_ = [&](const VectorXd& v, VectorXd* x) { cholesky->Solve(v, x); };
  const CgResult result = Solve(grid_, b_, 1e-10, 20);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.iterations, 1);
  EXPECT_EQ(applications_, 1);
  EXPECT_LT(Residual(grid_, b_), 1e-10);
}

TEST_F(ConjugateGradientsTest, EveryIterationAppliesThePreconditionerOnce) {
  for (const double tolerance : {1e-2, 1e-6, 1e-10}) {
    const CgResult result = Solve(grid_, b_, tolerance, 1000);
    EXPECT_TRUE(result.converged && result.positive);
    EXPECT_GT(result.iterations, 3);
    EXPECT_EQ(applications_, result.iterations);
    EXPECT_LT(Residual(grid_, b_), 1.01 * tolerance);
  }
}

TEST_F(ConjugateGradientsTest, TakesAsManyIterationsAsThereAreEigenvalues) {
  VectorXd entries = VectorXd::Constant(60, 2);
  entries.head(20).setConstant(7);
  entries.tail(20).setConstant(31);
  const VectorXd b = VectorXd::LinSpaced(60, -1, 2);
  EXPECT_EQ(Solve(DiagonalMatrix(entries), b, 1e-12, 20).iterations, 3);
  EXPECT_LT((x_ - b.cwiseQuotient(entries)).norm(), 1e-12 * x_.norm());
  precondition_ = [&](const VectorXd& v, VectorXd* x) { *x = v.cwiseQuotient(entries); };
  EXPECT_EQ(Solve(DiagonalMatrix(entries), b, 1e-12, 20).iterations, 1);
}

TEST_F(ConjugateGradientsTest, NothingIsDoneForNothing) {
  x_ = b_;
  const CgResult result = Solve(grid_, VectorXd::Zero(b_.size()), 1e-10, 20);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.iterations, 0);
  EXPECT_EQ(applications_, 0);
  EXPECT_EQ(x_, VectorXd::Zero(b_.size()));
}

TEST_F(ConjugateGradientsTest, GivesUpWhereTheTargetIsOutOfReach) {
  const CgResult result = Solve(grid_, b_, 1e-10, 20);
  EXPECT_FALSE(result.converged);
  EXPECT_TRUE(result.positive);
  EXPECT_GT(result.iterations, 0);
  EXPECT_LT(result.iterations, 20);
  EXPECT_EQ(applications_, result.iterations);
}

TEST_F(ConjugateGradientsTest, SeesADirectionOfNegativeCurvature) {
  VectorXd entries = VectorXd::LinSpaced(60, 1, 2);
  entries[30] = -5;
  const CgResult result = Solve(DiagonalMatrix(entries), VectorXd::Ones(60), 1e-10, 60);
  EXPECT_FALSE(result.positive);
  EXPECT_FALSE(result.converged);
}

}  // namespace
}  // namespace cirque

#include "cirque/linear/patch_smoother.h"

#include <functional>
#include <memory>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "cirque/core/parallel.h"
#include "cirque/linear/conjugate_gradients.h"
#include "cirque/linear/registry.h"

#include "tests/linear/grid_matrix.h"

namespace cirque {
namespace {

using Eigen::VectorXd;

/// A grid's Laplacian M with its factor, and A, which is M but for a few edges.
class PatchSmootherTest : public ::testing::Test {
 protected:
  explicit PatchSmootherTest(int side = 40)
      : side_(side), before_(GridMatrix(side, 1e-3, 0.2)), now_(before_) {
    EXPECT_TRUE(cholesky_->Factorize(before_));
  }

  /// Multiplies `count` edges' weights, all apart, by `factor` and more and more of it: equal
  /// changes would be as good as one for conjugate gradients.
  void ChangeEdges(int count, double factor, double growth = 1.4) {
    for (int k = 0; k < count; ++k, factor *= growth) {
      const int i = (2 + 2 * k) * side_ + (7 * k + 5) % (side_ - 2);
      const double more = (1 - factor) * now_.coeff(i + 1, i);
      now_.coeffRef(i, i) += more;
      now_.coeffRef(i + 1, i + 1) += more;
      now_.coeffRef(i + 1, i) -= more;
    }
  }

  VectorXd Apply(PatchSmoother* smoother, const VectorXd& b) {
    VectorXd x;
    smoother->Apply(b, solve_, &x);
    return x;
  }

  VectorXd Solve(const VectorXd& b) { return cholesky_->Solve(b); }

  VectorXd Image(const VectorXd& x) const { return now_.selfadjointView<Eigen::Lower>() * x; }

  VectorXd RandomVector() const { return VectorXd::Random(side_ * side_); }

  const int side_;
  const SparseMatrix before_;
  SparseMatrix now_;
  const std::unique_ptr<SparseCholesky> cholesky_ = MakeCholesky();
  const Preconditioner solve_ = [this](const VectorXd& b, VectorXd* x) { cholesky_->Solve(b, x); };
};

TEST_F(PatchSmootherTest, IsSymmetricAndPositive) {
  ChangeEdges(10, 0.02, 3);
  PatchSmoother smoother(now_, before_.diagonal());
  ASSERT_GE(smoother.num_rows(), 20);
  EXPECT_LT(smoother.num_rows(), side_ * side_ / 4) << "not local";
  for (int i = 0; i < 20; ++i) {
    const VectorXd x = RandomVector(), y = RandomVector();
    const VectorXd of_x = Apply(&smoother, x), of_y = Apply(&smoother, y);
    EXPECT_NEAR(x.dot(of_y), y.dot(of_x), 1e-12 * x.norm() * of_y.norm());
    EXPECT_GT(x.dot(of_x), 1e-3 * x.squaredNorm());
    EXPECT_GT((of_x - Solve(x)).norm(), 1e-3 * x.norm()) << "smooths nothing";
  }
}

TEST_F(PatchSmootherTest, DoesNotDependOnTheNumberOfThreads) {
  ChangeEdges(10, 0.02, 3);
  const VectorXd b = RandomVector();
  PatchSmoother smoother(now_, before_.diagonal());
  const VectorXd x = Apply(&smoother, b);
  const ThreadLimit limit(1);
  PatchSmoother alone(now_, before_.diagonal());
  EXPECT_EQ(Apply(&alone, b), x);
  EXPECT_EQ(Apply(&alone, b), x) << "something of the last right side was left";
  EXPECT_GT((x - Solve(b)).norm(), 1e-3 * b.norm());
}

/// Small enough to look at all eigenvalues.
class SmallPatchSmootherTest : public PatchSmootherTest {
 protected:
  SmallPatchSmootherTest() : PatchSmootherTest(15) {}

  /// Those of L' B L, A = L L': they are those of B A.
  VectorXd Eigenvalues(PatchSmoother* smoother) {
    const Eigen::MatrixXd a = Eigen::MatrixXd(now_).selfadjointView<Eigen::Lower>();
    const Eigen::MatrixXd l = a.llt().matrixL();
    Eigen::MatrixXd image = l;
    for (auto column : image.colwise()) column = Apply(smoother, column);
    const Eigen::MatrixXd product = l.transpose() * image;
    EXPECT_LT((product - product.transpose()).norm(), 1e-12 * product.norm());
    return product.selfadjointView<Eigen::Lower>().eigenvalues();
  }
};

TEST_F(SmallPatchSmootherTest, BringsTheSpectrumTogether) {
  ChangeEdges(2, 100);
  PatchSmoother smoother(now_, before_.diagonal()), nothing(now_, now_.diagonal());
  const VectorXd with = Eigenvalues(&smoother), without = Eigenvalues(&nothing);
  EXPECT_GT(with.minCoeff(), 0.5);
  EXPECT_LT(with.maxCoeff(), 2);
  EXPECT_GT(without.maxCoeff(), 20);
}

TEST_F(PatchSmootherTest, ConjugateGradientsNeedFewerIterations) {
  ChangeEdges(12, 2);
  PatchSmoother smoother(now_, before_.diagonal());
  const VectorXd b = VectorXd::LinSpaced(side_ * side_, 1, 3);
  VectorXd x;
  const CgResult without = ConjugateGradients(now_, b, solve_, 1e-6, 1000, &x);
  const CgResult with = ConjugateGradients(now_, b, smoother.Around(solve_), 1e-6, 1000, &x);
  EXPECT_TRUE(without.converged && with.converged);
  EXPECT_LE(2 * with.iterations, without.iterations);
  EXPECT_LT((Image(x) - b).norm(), 1.01e-6 * b.norm());
}

TEST_F(PatchSmootherTest, LeavesTheFactorAloneWhereLocalWorkIsNoUse) {
  ChangeEdges(3, 100);
  const VectorXd diagonal = now_.diagonal();
  VectorXd half = diagonal;
  half.head(half.size() / 2) *= 0.5;
  const VectorXd b = RandomVector();
  // Unchanged, hardly changed, of another system, changed in half of the rows.
  for (const VectorXd& before :
       {diagonal, VectorXd(1.01 * diagonal), VectorXd(), VectorXd(diagonal.head(side_)), half}) {
    PatchSmoother smoother(now_, before);
    EXPECT_EQ(smoother.num_rows(), 0);
    EXPECT_EQ(Apply(&smoother, b), Solve(b));
  }
}

TEST_F(PatchSmootherTest, KeepsAnExactFactorExact) {
  VectorXd altered = before_.diagonal();
  for (const int row : {0, 517, 518, 900}) altered[row] *= 0.3;
  PatchSmoother smoother(now_, altered);
  ASSERT_GT(smoother.num_rows(), 4);
  const VectorXd b = RandomVector(), x = Apply(&smoother, b);
  EXPECT_LT((x - Solve(b)).norm(), 1e-10 * x.norm());
  EXPECT_LT((Image(x) - b).norm(), 1e-10 * b.norm());
}

}  // namespace
}  // namespace cirque

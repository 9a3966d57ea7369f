#ifdef CIRQUE_CHOLMOD

#include "cirque/linear/cholmod/dense_trapezoid.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace cirque {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

using Factor = bool (*)(const DenseTrapezoid&);

/// Rows and columns of trapezoids on both sides of every change of method.
class DenseTrapezoidTest : public ::testing::TestWithParam<std::pair<int, int>> {
 protected:
  DenseTrapezoidTest() {
    const MatrixXd a = MatrixXd::Random(rows_, rows_);
    matrix_ = a * a.transpose() + MatrixXd::Identity(rows_, rows_);
  }

  /// The factor's columns by Eigen.
  MatrixXd Wanted() const { return MatrixXd(matrix_.llt().matrixL()).leftCols(columns_); }

  const int rows_ = GetParam().first, columns_ = GetParam().second;
  MatrixXd matrix_;
};

TEST_P(DenseTrapezoidTest, HasTheNumbersOfTheFactor) {
  for (const Factor factor : {Factor(FactorTrapezoid), Factor(FactorTrapezoidInParallel)}) {
    MatrixXd numbers = matrix_.leftCols(columns_);
    ASSERT_TRUE(factor({numbers.data(), rows_, columns_}));
    const MatrixXd lower = numbers.triangularView<Eigen::Lower>();
    EXPECT_LT((lower - Wanted()).norm(), 1e-11 * Wanted().norm());
  }
}

TEST_P(DenseTrapezoidTest, RefusesAPivotThatIsNotPositive) {
  matrix_(columns_ - 1, columns_ - 1) = -1;
  for (const Factor factor : {Factor(FactorTrapezoid), Factor(FactorTrapezoidInParallel)}) {
    MatrixXd numbers = matrix_.leftCols(columns_);
    EXPECT_FALSE(factor({numbers.data(), rows_, columns_}));
  }
}

// L L' of the rows, the identity below the columns, is undone in both directions.
TEST_P(DenseTrapezoidTest, SolvesForwardsAndBackwards) {
  MatrixXd numbers = Wanted();
  const DenseTrapezoid factored = {numbers.data(), rows_, columns_};
  MatrixXd l = MatrixXd::Identity(rows_, rows_);
  l.leftCols(columns_) = numbers;
  const VectorXd wanted = VectorXd::LinSpaced(rows_, -1, 2);
  VectorXd w = l * wanted;
  SolveWithTrapezoid(factored, w.data());
  EXPECT_LT((w - wanted).norm(), 1e-10 * wanted.norm());
  w = l.transpose() * wanted;
  w.tail(rows_ - columns_) = wanted.tail(rows_ - columns_);
  SolveWithTrapezoidTransposed(factored, w.data());
  EXPECT_LT((w - wanted).norm(), 1e-10 * wanted.norm());
}

TEST_P(DenseTrapezoidTest, SolvesForManyRightSidesAsForEach) {
  const MatrixXd numbers = Wanted(), sides = MatrixXd::Random(kSolvedTogether, rows_);
  const DenseTrapezoid factored = {const_cast<double*>(numbers.data()), rows_, columns_};
  MatrixXd forwards = sides, backwards = sides;  // by columns, so that rows of w lie side by side
  SolveTogetherWithTrapezoid(factored, forwards.data());
  SolveTogetherWithTrapezoidTransposed(factored, backwards.data());
  for (int c = 0; c < kSolvedTogether; ++c) {
    VectorXd w = sides.row(c), transposed = w;
    SolveWithTrapezoid(factored, w.data());
    SolveWithTrapezoidTransposed(factored, transposed.data());
    EXPECT_LT((forwards.row(c).transpose() - w).norm(), 1e-12 * w.norm());
    EXPECT_LT((backwards.row(c).transpose() - transposed).norm(), 1e-12 * transposed.norm());
  }
}

TEST_P(DenseTrapezoidTest, IsMultipliedByItsRowsTransposed) {
  const int rows = rows_ - 1, columns = std::min(columns_, rows);
  MatrixXd product = MatrixXd::Constant(rows, columns, 7);
  Multiply({matrix_.data() + 1, matrix_.data(), rows_, rows, columns, columns_}, product.data());
  const MatrixXd wanted =
      matrix_.block(1, 0, rows, columns_) * matrix_.block(0, 0, columns, columns_).transpose();
  EXPECT_LT((product - wanted).norm(), 1e-13 * wanted.norm());
}

INSTANTIATE_TEST_SUITE_P(Sizes, DenseTrapezoidTest,
                         ::testing::Values(std::pair(2, 1), std::pair(9, 8), std::pair(20, 8),
                                           std::pair(20, 9), std::pair(9, 9), std::pair(130, 128),
                                           std::pair(129, 129), std::pair(300, 140),
                                           std::pair(600, 300)));

}  // namespace
}  // namespace cirque

#endif  // CIRQUE_CHOLMOD

#ifdef CIRQUE_CHOLMOD

#include "cirque/linear/cholmod/dense_trapezoid.h"

#include <algorithm>
#include <complex>
#include <utility>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace cirque {
namespace {

/// Rows and columns of trapezoids on both sides of every change of method.
constexpr std::pair<int, int> kSizes[] = {{2, 1},     {9, 8},     {20, 8},    {20, 9},   {9, 9},
                                          {130, 128}, {129, 129}, {300, 140}, {600, 300}};

template <class Scalar>
using MatrixOf = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
template <class Scalar>
using VectorOf = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

/// Real and complex ones.
template <class Scalar>
class DenseTrapezoidTest : public ::testing::Test {
 protected:
  using Matrix = MatrixOf<Scalar>;
  using Factor = bool (*)(const DenseTrapezoid<Scalar>&);

  /// Hermitian and positive definite.
  static Matrix Definite(int rows) {
    const Matrix a = Matrix::Random(rows, rows);
    return a * a.adjoint() + Matrix::Identity(rows, rows);
  }

  /// The factor's columns by Eigen.
  static Matrix Wanted(const Matrix& matrix, int columns) {
    return Matrix(matrix.llt().matrixL()).leftCols(columns);
  }

  const Factor factors_[2] = {FactorTrapezoid<Scalar>, FactorTrapezoidInParallel<Scalar>};
};

using Scalars = ::testing::Types<double, std::complex<double>>;
TYPED_TEST_SUITE(DenseTrapezoidTest, Scalars);

TYPED_TEST(DenseTrapezoidTest, HasTheNumbersOfTheFactor) {
  for (const auto& [rows, columns] : kSizes) {
    const MatrixOf<TypeParam> matrix = this->Definite(rows), wanted = this->Wanted(matrix, columns);
    for (const auto factor : this->factors_) {
      MatrixOf<TypeParam> numbers = matrix.leftCols(columns);
      ASSERT_TRUE(factor({numbers.data(), rows, columns}));
      const MatrixOf<TypeParam> lower = numbers.template triangularView<Eigen::Lower>();
      EXPECT_LT((lower - wanted).norm(), 1e-11 * wanted.norm()) << rows << " x " << columns;
    }
  }
}

TYPED_TEST(DenseTrapezoidTest, RefusesAPivotThatIsNotPositive) {
  for (const auto& [rows, columns] : kSizes) {
    MatrixOf<TypeParam> matrix = this->Definite(rows);
    matrix(columns - 1, columns - 1) = -1;
    for (const auto factor : this->factors_) {
      MatrixOf<TypeParam> numbers = matrix.leftCols(columns);
      EXPECT_FALSE(factor({numbers.data(), rows, columns}));
    }
  }
}

// L L* of the rows, the identity below the columns, is undone in both directions.
TYPED_TEST(DenseTrapezoidTest, SolvesForwardsAndBackwards) {
  for (const auto& [rows, columns] : kSizes) {
    MatrixOf<TypeParam> numbers = this->Wanted(this->Definite(rows), columns);
    const DenseTrapezoid<TypeParam> factored = {numbers.data(), rows, columns};
    MatrixOf<TypeParam> l = MatrixOf<TypeParam>::Identity(rows, rows);
    l.leftCols(columns) = numbers;
    const VectorOf<TypeParam> wanted = VectorOf<TypeParam>::Random(rows);
    VectorOf<TypeParam> w = l * wanted;
    SolveWithTrapezoid(factored, w.data());
    EXPECT_LT((w - wanted).norm(), 1e-10 * wanted.norm());
    w = l.adjoint() * wanted;
    w.tail(rows - columns) = wanted.tail(rows - columns);
    SolveWithTrapezoidTransposed(factored, w.data());
    EXPECT_LT((w - wanted).norm(), 1e-10 * wanted.norm());
  }
}

TYPED_TEST(DenseTrapezoidTest, IsMultipliedByItsRowsTransposed) {
  for (const auto& [all, inner] : kSizes) {
    const MatrixOf<TypeParam> matrix = MatrixOf<TypeParam>::Random(all, inner);
    const int rows = all - 1, columns = std::min(inner, rows);
    MatrixOf<TypeParam> product = MatrixOf<TypeParam>::Constant(rows, columns, 7);
    Multiply<TypeParam>({matrix.data() + 1, matrix.data(), all, rows, columns, inner},
                        product.data());
    const MatrixOf<TypeParam> wanted = matrix.bottomRows(rows) * matrix.topRows(columns).adjoint();
    EXPECT_LT((product - wanted).norm(), 1e-13 * wanted.norm());
  }
}

TEST(DenseTrapezoid, SolvesForManyRightSidesAsForEach) {
  using Eigen::MatrixXd;
  for (const auto& [rows, columns] : kSizes) {
    MatrixXd numbers = MatrixXd::Random(rows, columns);
    numbers.diagonal().array() += columns;
    const MatrixXd sides = MatrixXd::Random(kSolvedTogether, rows);
    const DenseTrapezoid<double> factored = {numbers.data(), rows, columns};
    MatrixXd forwards = sides, backwards = sides;  // by columns: rows of w lie side by side
    SolveTogetherWithTrapezoid(factored, forwards.data());
    SolveTogetherWithTrapezoidTransposed(factored, backwards.data());
    for (int c = 0; c < kSolvedTogether; ++c) {
      Eigen::VectorXd w = sides.row(c), transposed = w;
      SolveWithTrapezoid(factored, w.data());
      SolveWithTrapezoidTransposed(factored, transposed.data());
      EXPECT_LT((forwards.row(c).transpose() - w).norm(), 1e-12 * w.norm());
      EXPECT_LT((backwards.row(c).transpose() - transposed).norm(), 1e-12 * transposed.norm());
    }
  }
}

}  // namespace
}  // namespace cirque

#endif  // CIRQUE_CHOLMOD

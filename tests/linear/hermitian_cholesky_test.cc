#include "cirque/linear/hermitian_cholesky.h"

#include <complex>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "cirque/core/parallel.h"

namespace cirque {
namespace {

/// B* B + shift for a banded B of random numbers.
Eigen::MatrixXcd BandedHermitian(int n, double shift) {
  std::srand(7);
  Eigen::MatrixXcd b = Eigen::MatrixXcd::Zero(n, n);
  for (int i = 0; i < n; ++i) {
    for (int j = std::max(0, i - 2); j < std::min(n, i + 3); ++j) {
      b(i, j) = {std::rand() / (RAND_MAX + 1.0) - 0.5, std::rand() / (RAND_MAX + 1.0) - 0.5};
    }
  }
  return b.adjoint() * b + shift * Eigen::MatrixXcd::Identity(n, n);
}

ComplexSparseMatrix Lower(const Eigen::MatrixXcd& dense) {
  return ComplexSparseMatrix(dense.sparseView()).triangularView<Eigen::Lower>();
}

TEST(HermitianCholesky, SolvesOnePatternWithSeveralValues) {
  HermitianCholesky cholesky;
  for (const double shift : {1.0, 0.1}) {
    const Eigen::MatrixXcd a = BandedHermitian(40, shift);
    ASSERT_GT(a.imag().cwiseAbs().maxCoeff(), 0.1);
    const Eigen::VectorXcd x = Eigen::VectorXcd::Random(40);
    ASSERT_TRUE(cholesky.Factorize(Lower(a)));
    EXPECT_LT((cholesky.Solve(a * x) - x).norm(), 1e-12 * x.norm());
  }
}

/// Of a square grid with diagonals: each edge's entry is another unit, the diagonal's 6 and a shift.
ComplexSparseMatrix TurnedGrid(int side, double shift) {
  std::vector<Eigen::Triplet<std::complex<double>>> entries;
  for (int i = 0; i < side * side; ++i) {
    entries.emplace_back(i, i, 6 + shift);
    const bool right = i % side + 1 < side, up = i + side < side * side;
    const auto add = [&](int step) { entries.emplace_back(i + step, i, std::polar(1.0, 1.7 * i)); };
    if (right) add(1);
    if (up) add(side);
    if (right && up) add(side + 1);
  }
  ComplexSparseMatrix lower(side * side, side * side);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

// By columns and by dense blocks, these in subtrees and at the top.
TEST(HermitianCholesky, SolvesSystemsOfEverySize) {
  for (const int side : {5, 31, 32, 80, 150}) {
    HermitianCholesky cholesky;
    for (const double shift : {0.1, 3.0}) {
      const ComplexSparseMatrix lower = TurnedGrid(side, shift);
      const Eigen::VectorXcd x = Eigen::VectorXcd::Random(lower.cols());
      const Eigen::VectorXcd b = lower.selfadjointView<Eigen::Lower>() * x;
      ASSERT_TRUE(cholesky.Factorize(lower));
      EXPECT_LT((cholesky.Solve(b) - x).norm(), 1e-12 * x.norm()) << side;
    }
    EXPECT_FALSE(cholesky.Factorize(TurnedGrid(side, -6.5)));
    EXPECT_TRUE(cholesky.Factorize(TurnedGrid(side, 1)));
  }
}

TEST(HermitianCholesky, DoesNotDependOnTheNumberOfThreads) {
  const ComplexSparseMatrix lower = TurnedGrid(150, 0.1);
  const Eigen::VectorXcd b = Eigen::VectorXcd::Random(lower.cols());
  const auto solve = [&] {
    HermitianCholesky cholesky;
    EXPECT_TRUE(cholesky.Factorize(lower));
    return cholesky.Solve(b);
  };
  const Eigen::VectorXcd x = solve();
  EXPECT_GT(x.norm(), 1);
  const ThreadLimit limit(1);
  EXPECT_EQ(solve(), x);
}

TEST(HermitianCholesky, RefusesAnIndefiniteMatrix) {
  HermitianCholesky cholesky;
  EXPECT_FALSE(cholesky.Factorize(Lower(BandedHermitian(40, -1))));
}

}  // namespace
}  // namespace cirque

#include "cirque/linear/hermitian_cholesky.h"

#include <complex>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

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

TEST(HermitianCholesky, SolvesLargeSystemsByDenseBlocks) {
  // Of a path: 2 and a shift on the diagonal, i beside it.
  constexpr int kUnknowns = 6000;
  for (const double shift : {0.1, -3.0}) {
    std::vector<Eigen::Triplet<std::complex<double>>> entries;
    for (int i = 0; i < kUnknowns; ++i) {
      entries.emplace_back(i, i, 2 + shift);
      if (i > 0) entries.emplace_back(i, i - 1, std::complex<double>(0, 1));
    }
    ComplexSparseMatrix lower(kUnknowns, kUnknowns);
    lower.setFromTriplets(entries.begin(), entries.end());
    HermitianCholesky cholesky;
    ASSERT_EQ(cholesky.Factorize(lower), shift > 0);
    if (shift < 0) continue;
    const Eigen::VectorXcd x = Eigen::VectorXcd::Random(kUnknowns);
    const Eigen::VectorXcd b = lower.selfadjointView<Eigen::Lower>() * x;
    EXPECT_LT((cholesky.Solve(b) - x).norm(), 1e-12 * x.norm());
  }
}

TEST(HermitianCholesky, RefusesAnIndefiniteMatrix) {
  HermitianCholesky cholesky;
  EXPECT_FALSE(cholesky.Factorize(Lower(BandedHermitian(40, -1))));
}

}  // namespace
}  // namespace cirque

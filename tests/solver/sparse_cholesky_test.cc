#include "cirque/solver/sparse_cholesky.h"

#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace cirque {
namespace {

/// A grid Laplacian plus a diagonal: sparse, positive definite.
SparseMatrix GridMatrix(int n, double diagonal) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto couple = [&](int i, int j) {
    entries.emplace_back(i, i, 1);
    entries.emplace_back(j, j, 1);
    entries.emplace_back(std::max(i, j), std::min(i, j), -1);
  };
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      entries.emplace_back(y * n + x, y * n + x, diagonal);
      if (x > 0) couple(y * n + x, y * n + x - 1);
      if (y > 0) couple(y * n + x, y * n + x - n);
    }
  }
  SparseMatrix lower(n * n, n * n);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

class EveryLinearSolver : public ::testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<SparseCholesky> Make() const { return (*LinearSolvers().Find(GetParam()))(); }
};

TEST_P(EveryLinearSolver, SolvesToRounding) {
  const SparseMatrix lower = GridMatrix(20, 0.5);
  const Eigen::VectorXd wanted = Eigen::VectorXd::LinSpaced(lower.cols(), -1, 2);
  const Eigen::VectorXd right_side = lower.selfadjointView<Eigen::Lower>() * wanted;
  const auto cholesky = Make();
  ASSERT_TRUE(cholesky->Factorize(lower));
  EXPECT_LT((cholesky->Solve(right_side) - wanted).lpNorm<Eigen::Infinity>(), 1e-13);
}

TEST_P(EveryLinearSolver, ReusesTheAnalysisOfAnEqualPattern) {
  const auto cholesky = Make();
  ASSERT_TRUE(cholesky->Factorize(GridMatrix(8, 0.5)));
  ASSERT_TRUE(cholesky->Factorize(GridMatrix(8, 2)));
  EXPECT_EQ(cholesky->symbolic_analyses(), 1);
  ASSERT_TRUE(cholesky->Factorize(GridMatrix(9, 2)));
  EXPECT_EQ(cholesky->symbolic_analyses(), 2);
  EXPECT_EQ(cholesky->factorizations(), 3);
  EXPECT_EQ(cholesky->Solve(Eigen::VectorXd::Ones(81)).size(), 81);
}

TEST_P(EveryLinearSolver, RefusesAnIndefiniteMatrix) {
  EXPECT_FALSE(Make()->Factorize(GridMatrix(6, -1)));
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryLinearSolver, ::testing::ValuesIn(LinearSolvers().Names()));

}  // namespace
}  // namespace cirque

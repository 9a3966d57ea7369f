#include <gtest/gtest.h>

#include "cirque/linear/registry.h"

#include "tests/linear/grid_matrix.h"

namespace cirque {
namespace {

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

// Of few unknowns and of many, by itself and behind an elimination, with numbers in double and in single
// precision.
TEST_P(EveryLinearSolver, SolvesForManyRightSidesAsForEach) {
  for (const int side : {8, 100}) {
    const Eigen::MatrixXd sides = Eigen::MatrixXd::Random(side * side, 10);
    std::unique_ptr<SparseCholesky> solvers[] = {Make(), MakeCholesky(GetParam())};
    for (const auto& cholesky : solvers) {
      ASSERT_TRUE(cholesky->Factorize(GridMatrix(side, 0.5)));
      for (const double tolerance : {1e-13, 1e-5}) {
        Eigen::MatrixXd together;
        cholesky->SolveTogether(sides, &together);
        for (int c = 0; c < sides.cols(); ++c) {
          const Eigen::VectorXd alone = cholesky->Solve(sides.col(c));
          EXPECT_GT(alone.norm(), 1);
          EXPECT_LT((together.col(c) - alone).norm(), tolerance * alone.norm());
        }
        cholesky->KeepInSinglePrecision();
      }
    }
  }
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

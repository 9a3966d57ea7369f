// The dense triangular solves in single precision against Eigen's on the rounded trapezoid.
#include "cirque/linear/cholmod/supernode_tiles.h"

#include <tuple>

#include <Eigen/Core>
#include <gtest/gtest.h>

namespace cirque {
namespace {

/// Rows and columns.
class SupernodeTilesTest : public ::testing::TestWithParam<std::tuple<int, int>> {
 protected:
  SupernodeTilesTest()
      : rows_(std::get<0>(GetParam()) + columns_),
        dense_(Eigen::MatrixXd::Random(rows_, columns_)) {
    dense_.diagonal().array() += 4;
    stored_.resize(SupernodeTiles(rows_, columns_).Size(), -7);
    SupernodeTiles(rows_, columns_).Store(dense_.data(), stored_.data());
    rounded_ = dense_.cast<float>().cast<double>();
    w_ = Eigen::VectorXd::Zero(SupernodeTiles(rows_, columns_).NumPadded());
    w_.head(rows_).setRandom();
  }

  auto Top() const { return rounded_.topRows(columns_).triangularView<Eigen::Lower>(); }
  Eigen::MatrixXd Below() const { return rounded_.bottomRows(rows_ - columns_); }

  const int columns_ = std::get<1>(GetParam()), rows_;
  Eigen::MatrixXd dense_, rounded_;
  std::vector<float> stored_;
  Eigen::VectorXd w_;
};

TEST_P(SupernodeTilesTest, SolvesAndTakesOutOfTheRowsBelow) {
  const Eigen::VectorXd x = Top().solve(w_.head(columns_));
  const Eigen::VectorXd below = w_.segment(columns_, rows_ - columns_) - Below() * x;
  SupernodeTiles(rows_, columns_).Solve(stored_.data(), w_.data());
  EXPECT_LT((w_.head(columns_) - x).norm(), 1e-13);
  EXPECT_LT((w_.segment(columns_, rows_ - columns_) - below).norm(), 1e-13);
  EXPECT_EQ(w_.tail(w_.size() - rows_).norm(), 0);
}

TEST_P(SupernodeTilesTest, SolvesTransposedGivenTheRowsBelow) {
  const Eigen::VectorXd below = w_.segment(columns_, rows_ - columns_);
  const Eigen::VectorXd rest = w_.head(columns_) - Below().transpose() * below;
  const Eigen::VectorXd x =
      rounded_.topRows(columns_).transpose().triangularView<Eigen::Upper>().solve(rest);
  SupernodeTiles(rows_, columns_).SolveTransposed(stored_.data(), w_.data());
  EXPECT_LT((w_.head(columns_) - x).norm(), 1e-13);
  EXPECT_EQ((w_.segment(columns_, rows_ - columns_) - below).norm(), 0);
}

TEST_P(SupernodeTilesTest, IsStoredWhereTheMatrixIsAsWell) {
  if (rows_ < 3) GTEST_SKIP() << "the tile is longer than the matrix";
  SupernodeTiles(rows_, columns_).Store(dense_.data(), reinterpret_cast<float*>(dense_.data()));
  EXPECT_GT(stored_.front(), 2);
  const float* in_place = reinterpret_cast<const float*>(dense_.data());
  EXPECT_TRUE(std::equal(stored_.begin(), stored_.end(), in_place));
}

INSTANTIATE_TEST_SUITE_P(Sizes, SupernodeTilesTest,
                         ::testing::Combine(::testing::Values(0, 1, 2, 3, 4, 5, 30),
                                            ::testing::Values(1, 2, 3, 4, 5, 6, 7, 8, 21)));

}  // namespace
}  // namespace cirque

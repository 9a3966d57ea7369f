// Symmetric matrices by their lower triangle, beside dense ones.
#include "cirque/linear/sparse_matrix.h"

#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "tests/linear/grid_matrix.h"

namespace cirque {
namespace {

TEST(SparseMatrix, ItsDiagonalIsTheDenseOnes) {
  const SparseMatrix lower = GridMatrix(7, 0.5, 3);
  const Eigen::MatrixXd dense(lower);
  EXPECT_EQ(Diagonal(lower), dense.diagonal());
  for (int j = 0; j < lower.cols(); ++j) EXPECT_EQ(DiagonalEntry(lower, j), dense(j, j));
}

TEST(SparseMatrix, DiagonalEntriesCanBeSet) {
  SparseMatrix lower = GridMatrix(4, 0.5, 1);
  const Eigen::MatrixXd before(lower);
  DiagonalEntry(&lower, 5) = 42;
  Eigen::MatrixXd difference = Eigen::MatrixXd(lower) - before;
  EXPECT_EQ(difference(5, 5), 42 - before(5, 5));
  difference(5, 5) = 0;
  EXPECT_EQ(difference.norm(), 0);
}

TEST(SparseMatrix, EveryEntryBelowTheDiagonalIsVisitedOnce) {
  const SparseMatrix lower = GridMatrix(5, 0.5, 2);
  const Eigen::MatrixXd dense(lower);
  Eigen::MatrixXd seen = Eigen::MatrixXd::Zero(dense.rows(), dense.cols());
  ForEachOffDiagonal(lower, [&](int i, int j, int p) {
    ASSERT_GT(i, j);
    EXPECT_EQ(seen(i, j), 0) << "visited twice";
    seen(i, j) = lower.valuePtr()[p];
  });
  EXPECT_EQ(seen, Eigen::MatrixXd(dense.triangularView<Eigen::StrictlyLower>()));
}

TEST(SparseMatrix, AColumnsEntriesAreThoseOfTheWholeVisit) {
  const SparseMatrix lower = GridMatrix(5, 0.5, 2);
  std::set<std::pair<int, int>> all, by_column;
  ForEachOffDiagonal(lower, [&](int i, int j, int) { all.emplace(i, j); });
  for (int j = 0; j < lower.cols(); ++j) {
    ForEachBelowDiagonal(lower, j, [&](int i, int) { by_column.emplace(i, j); });
  }
  EXPECT_EQ(all.size(), 2u * 5 * 4);
  EXPECT_EQ(all, by_column);
}

}  // namespace
}  // namespace cirque

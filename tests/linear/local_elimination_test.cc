// What ranks do to distributed rows before multigrid has them.
#include "cirque/linear/local_elimination.h"

#include <vector>

#include <gtest/gtest.h>

#include "cirque/linear/rank_solver.h"

#include "tests/linear/grid_matrix.h"
#include "tests/linear/thread_ranks.h"

namespace cirque {
namespace {

constexpr int kRanks = 3, kSide = 12;

/// A rank's rows of a matrix whose unknowns are shared out in equal runs.
struct Share {
  RankUnknowns unknowns;
  LocalRows rows;

  Share(const SparseMatrix& lower, const Ranks& ranks) {
    const auto n = static_cast<int>(lower.cols());
    for (int r = 0; r <= ranks.num_ranks(); ++r)
      unknowns.first.push_back(n * r / ranks.num_ranks());
    const int first = unknowns.first[ranks.rank()], end = unknowns.first[ranks.rank() + 1];
    std::vector<int> slot(n);
    for (int i = 0; i < n; ++i) {
      const bool is_own = i >= first && i < end;
      slot[i] = is_own ? i - first : end - first + static_cast<int>(unknowns.ghosts.size());
      if (!is_own) unknowns.ghosts.push_back(i);
    }
    rows = OwnRows(lower, slot, end - first);
  }
};

TEST(Halo, GhostsHaveTheirOwnersValues) {
  const SparseMatrix lower = GridMatrix(kSide, 1);
  RunOnThreadRanks(kRanks, [&](Ranks& ranks) {
    const Share share(lower, ranks);
    const Halo halo(&ranks, share.unknowns);
    Eigen::VectorXd values = Eigen::VectorXd::Constant(halo.num_local(), -1);
    const int first = share.unknowns.first[ranks.rank()];
    for (int k = 0; k < halo.num_own(); ++k) values[k] = 0.5 * (first + k);
    halo.Fill(&values);
    for (int g = 0; g < halo.num_ghosts(); ++g) {
      EXPECT_EQ(values[halo.num_own() + g], 0.5 * share.unknowns.ghosts[g]);
    }
  });
}

TEST(LocalElimination, SolvesWithTheWholeMatrix) {
  const SparseMatrix lower = GridMatrix(kSide, 1e-2, 3);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(lower.cols(), -1, 2);
  RunOnThreadRanks(kRanks, [&](Ranks& ranks) {
    const Share share(lower, ranks);
    const Halo halo(&ranks, share.unknowns);
    RankSolver solver(&halo, "dense", 50);
    solver.SetRows(share.rows, {});
    EXPECT_NEAR(solver.MeanDiagonal(), Diagonal(lower).mean(), 1e-12);
    solver.Damp(0);
    SolveSummary summary;
    Eigen::VectorXd x;
    const Eigen::VectorXd mine = b.segment(share.unknowns.first[ranks.rank()], halo.num_own());
    ASSERT_TRUE(solver.Solve(mine, 1e-10, &x, &summary));
    EXPECT_LT((solver.Times(x) - mine).lpNorm<Eigen::Infinity>(), 1e-10);
    EXPECT_EQ(summary.factorizations, 1);
  });
}

/// The lower triangle of a chain 0 - 1 - ... with these couplings, 4 on the diagonal.
SparseMatrix Chain(const std::vector<double>& couplings) {
  const int n = static_cast<int>(couplings.size()) + 1;
  SparseMatrix chain(n, n);
  for (int i = 0; i < n; ++i) {
    chain.insert(i, i) = 4;
    if (i + 1 < n) chain.insert(i + 1, i) = couplings[i];
  }
  chain.makeCompressed();
  return chain;
}

TEST(LocalElimination, ComplementKeepsWhatCouplesToOtherRanks) {
  // On two ranks every other unknown goes, those at the border stay.
  const SparseMatrix chain = Chain({-1, -1, -1, -1, -1, -1, -1});
  RunOnThreadRanks(2, [&](Ranks& ranks) {
    const Share share(chain, ranks);
    const Halo halo(&ranks, share.unknowns);
    LocalElimination elimination(share.rows, halo);
    EXPECT_TRUE(elimination.SetValues(share.rows, halo));
    EXPECT_EQ(elimination.num_kept(), 2);
    const MatrixRows rows = elimination.Complement(share.rows);
    EXPECT_EQ(rows.size, 4);
    ASSERT_EQ(rows.num_rows(), 2);
    // The first rank keeps 1 and 3 of 0 ... 3: 1 has lost 0 and 2, 3 has lost 2.
    const int inner = ranks.rank() == 0 ? 0 : rows.start[1];
    EXPECT_DOUBLE_EQ(rows.value[inner + ranks.rank()], 3.5);
  });
}

TEST(LocalElimination, APositiveBorderCouplingChangesSign) {
  // 1 couples to 0 and, on the other rank, to 2: positively, as triangles to their vertices.
  const SparseMatrix chain = Chain({1, 1, -1});
  RunOnThreadRanks(2, [&](Ranks& ranks) {
    const Share share(chain, ranks);
    const Halo halo(&ranks, share.unknowns);
    LocalElimination elimination(share.rows, halo);
    ASSERT_TRUE(elimination.SetValues(share.rows, halo));
    const MatrixRows rows = elimination.Complement(share.rows);
    EXPECT_GT(rows.num_rows(), 0);
    for (int i = 0; i < rows.num_rows(); ++i) {
      int diagonals = 0;
      for (int k = rows.start[i]; k < rows.start[i + 1]; ++k) {
        const bool is_diagonal = rows.value[k] > 2;
        EXPECT_EQ(rows.value[k] > 0, is_diagonal);
        diagonals += is_diagonal;
      }
      EXPECT_EQ(diagonals, 1);
    }
  });
}

TEST(LocalElimination, AnIndefiniteMatrixIsNoticedOnAllRanks) {
  SparseMatrix lower = GridMatrix(kSide, 1e-2);
  DiagonalEntry(&lower, 0) = -1;
  RunOnThreadRanks(kRanks, [&](Ranks& ranks) {
    const Share share(lower, ranks);
    const Halo halo(&ranks, share.unknowns);
    RankSolver solver(&halo, "dense", 50);
    solver.SetRows(share.rows, {});
    solver.Damp(0);
    SolveSummary summary;
    Eigen::VectorXd x;
    EXPECT_FALSE(solver.Solve(Eigen::VectorXd::Ones(halo.num_own()), 1e-10, &x, &summary));
  });
}

}  // namespace
}  // namespace cirque

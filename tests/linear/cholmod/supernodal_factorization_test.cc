#ifdef CIRQUE_CHOLMOD

#include "cirque/linear/cholmod/supernodal_factorization.h"

#include <gtest/gtest.h>

#include "cirque/core/parallel.h"

#include "tests/linear/cholmod/analysed_factor.h"
#include "tests/linear/grid_matrix.h"

namespace cirque {
namespace {

constexpr int kSide = 150;

/// All stored numbers of the lower trapezoids, supernode by supernode.
Eigen::VectorXd Numbers(const cholmod_factor& factor) {
  const SupernodalTree tree(factor);
  std::vector<double> numbers;
  for (int s = 0; s < tree.num_supernodes(); ++s) {
    const double* start =
        static_cast<const double*>(factor.x) + static_cast<const int*>(factor.px)[s];
    for (int j = 0; j < tree.NumColumns(s); ++j) {
      const double* column = start + static_cast<std::size_t>(j) * tree.NumRows(s);
      numbers.insert(numbers.end(), column + j, column + tree.NumRows(s));
    }
  }
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(),
                                           static_cast<Eigen::Index>(numbers.size()));
}

class SupernodalFactorizationTest : public ::testing::Test {
 protected:
  SupernodalFactorizationTest() { ours_.AllocateNumbers(); }

  Eigen::VectorXd Solve() { return Solve(b_); }

  Eigen::VectorXd Solve(const Eigen::VectorXd& b) {
    Eigen::VectorXd x;
    SupernodalSolver(factorization_.tree(), static_cast<const int*>(ours_.factor().Perm))
        .Solve(RealSupernodes(factorization_), b, &x);
    return x;
  }

  Eigen::MatrixXd SolveTogether(const Eigen::MatrixXd& b) {
    Eigen::MatrixXd x;
    SupernodalSolver(factorization_.tree(), static_cast<const int*>(ours_.factor().Perm))
        .SolveTogether(RealSupernodes(factorization_), b, &x);
    return x;
  }

  const Eigen::VectorXd b_ = Eigen::VectorXd::LinSpaced(kSide * kSide, -1, 2);
  const SparseMatrix lower_ = GridMatrix(kSide, 0.1, 0.5);
  AnalysedFactor ours_{lower_};
  SupernodalFactorization<double> factorization_{lower_, ours_.factor()};
};

TEST_F(SupernodalFactorizationTest, GivesTheNumbersOfCholmod) {
  ASSERT_TRUE(factorization_.Compute(lower_));
  AnalysedFactor cholmods(lower_);
  cholmods.FactorizeByCholmod();
  const Eigen::VectorXd ours = Numbers(ours_.factor()), wanted = Numbers(cholmods.factor());
  EXPECT_GT(factorization_.tree().top_supernodes().size(), 5U);
  EXPECT_GT(wanted.norm(), 100);
  EXPECT_LT((ours - wanted).lpNorm<Eigen::Infinity>(), 1e-13 * wanted.lpNorm<Eigen::Infinity>());
}

TEST_F(SupernodalFactorizationTest, SolvesForASingleEntry) {
  ASSERT_TRUE(factorization_.Compute(lower_));
  for (const int i : {0, kSide * kSide / 2, kSide * kSide - 1}) {
    const Eigen::VectorXd unit = Eigen::VectorXd::Unit(kSide * kSide, i);
    const Eigen::VectorXd x = Solve(unit);
    EXPECT_GT(x.minCoeff(), 0);  // a Laplacian's inverse: every entry is reached
    const Eigen::VectorXd rest = lower_.selfadjointView<Eigen::Lower>() * x - unit;
    EXPECT_LT(rest.lpNorm<Eigen::Infinity>(), 1e-13);
  }
}

// Dense ones, single entries and zeros, more than are solved for at once.
TEST_F(SupernodalFactorizationTest, SolvesForManyRightSidesAsForEach) {
  ASSERT_TRUE(factorization_.Compute(lower_));
  Eigen::MatrixXd sides = Eigen::MatrixXd::Zero(kSide * kSide, 11);
  for (int c = 0; c < 8; ++c) sides(1000 * c + 7, c) = 1 + c;
  sides.col(9) = b_;
  sides.col(10) = b_.reverse();
  const Eigen::MatrixXd together = SolveTogether(sides);
  for (int c = 0; c < 11; ++c) {
    const Eigen::VectorXd alone = Solve(sides.col(c));
    EXPECT_EQ(alone.isZero(0), c == 8);
    EXPECT_LE((together.col(c) - alone).norm(), 1e-13 * alone.norm()) << c;
  }
  const ThreadLimit limit(1);
  EXPECT_EQ(SolveTogether(sides), together);
}

TEST_F(SupernodalFactorizationTest, DoesNotDependOnTheNumberOfThreads) {
  ASSERT_TRUE(factorization_.Compute(lower_));
  const Eigen::VectorXd numbers = Numbers(ours_.factor()), x = Solve();
  EXPECT_GT(numbers.norm(), 100);
  EXPECT_GT(x.norm(), 1);
  const ThreadLimit limit(1);
  ASSERT_TRUE(factorization_.Compute(lower_));
  EXPECT_EQ(Numbers(ours_.factor()), numbers);
  EXPECT_EQ(Solve(), x);
}

TEST_F(SupernodalFactorizationTest, SolvesToRounding) {
  ASSERT_TRUE(factorization_.Compute(lower_));
  const Eigen::VectorXd x = Solve();
  EXPECT_GT(x.norm(), 1);
  EXPECT_LT((lower_.selfadjointView<Eigen::Lower>() * x - b_).norm(), 1e-13 * b_.norm());
}

TEST_F(SupernodalFactorizationTest, TakesOtherNumbersInTheSamePattern) {
  ASSERT_TRUE(factorization_.Compute(lower_));
  const Eigen::VectorXd numbers = Numbers(ours_.factor());
  ASSERT_TRUE(factorization_.Compute(4 * lower_));
  EXPECT_LT((Numbers(ours_.factor()) - 2 * numbers).norm(), 1e-14 * numbers.norm());
}

// A single negative entry is met in its subtree, a negative sum of all only by the last pivot.
TEST_F(SupernodalFactorizationTest, RefusesWhatIsNotPositiveDefiniteInSubtreesAndAtTheTop) {
  SparseMatrix negative = lower_;
  const auto& groups = factorization_.tree().groups();
  const int column = factorization_.tree().FirstColumn(groups[3].front().begin);
  const int unknown = static_cast<const int*>(ours_.factor().Perm)[column];
  negative.coeffRef(unknown, unknown) = -1;
  EXPECT_FALSE(factorization_.Compute(negative));
  EXPECT_FALSE(factorization_.Compute(GridMatrix(kSide, -1e-5)));
  EXPECT_TRUE(factorization_.Compute(lower_));
}

}  // namespace
}  // namespace cirque

#endif  // CIRQUE_CHOLMOD

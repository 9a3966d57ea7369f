#ifdef CIRQUE_CHOLMOD

#include "cirque/linear/cholmod/single_precision_factor.h"

#include <memory>

#include <gtest/gtest.h>

#include "cirque/core/parallel.h"
#include "cirque/linear/lagged_factorization.h"
#include "cirque/linear/registry.h"

#include "tests/linear/cholmod/analysed_factor.h"
#include "tests/linear/grid_matrix.h"

namespace cirque {
namespace {

constexpr int kSide = 150;  ///< large enough for a supernodal factor

class SinglePrecisionFactorTest : public ::testing::Test {
 protected:
  void FactorRoughly(const SparseMatrix& lower) {
    ASSERT_TRUE(cholesky_->Factorize(lower));
    cholesky_->KeepInSinglePrecision();
  }

  /// |x - A^-1 b| / |A^-1 b|
  double Error(const SparseMatrix& lower) {
    const Eigen::VectorXd wanted = Eigen::VectorXd::LinSpaced(lower.cols(), -1, 2);
    const Eigen::VectorXd x = cholesky_->Solve(lower.selfadjointView<Eigen::Lower>() * wanted);
    return (x - wanted).norm() / wanted.norm();
  }

  const SparseMatrix lower_ = GridMatrix(kSide, 0.1, 0.5);
  const std::unique_ptr<SparseCholesky> cholesky_ = MakeCholmodCholesky();
};

TEST_F(SinglePrecisionFactorTest, SolvesToSixDigits) {
  FactorRoughly(lower_);
  EXPECT_LT(Error(lower_), 1e-5);
  EXPECT_GT(Error(lower_), 1e-10) << "nothing was rounded";
}

TEST_F(SinglePrecisionFactorTest, IsSymmetricToRoundingOfDoubles) {
  FactorRoughly(lower_);
  const Eigen::VectorXd a = Eigen::VectorXd::Random(lower_.cols());
  const Eigen::VectorXd b = Eigen::VectorXd::Random(lower_.cols());
  const double ab = a.dot(cholesky_->Solve(b)), ba = b.dot(cholesky_->Solve(a));
  EXPECT_NEAR(ab, ba, 1e-13 * a.norm() * b.norm() / 0.1);
  EXPECT_NE(ab, 0);
}

TEST_F(SinglePrecisionFactorTest, DoesNotDependOnTheNumberOfThreads) {
  FactorRoughly(lower_);
  const Eigen::VectorXd b = Eigen::VectorXd::Random(lower_.cols());
  const Eigen::VectorXd x = cholesky_->Solve(b);
  EXPECT_GT(x.norm(), 0);
  const ThreadLimit limit(1);
  EXPECT_EQ((cholesky_->Solve(b) - x).norm(), 0);
}

TEST_F(SinglePrecisionFactorTest, LastsUntilTheNextFactorization) {
  FactorRoughly(lower_);
  cholesky_->KeepInSinglePrecision();
  EXPECT_LT(Error(lower_), 1e-5);
  ASSERT_TRUE(cholesky_->Factorize(lower_));
  EXPECT_LT(Error(lower_), 1e-12);
  EXPECT_EQ(cholesky_->symbolic_analyses(), 1);
}

TEST_F(SinglePrecisionFactorTest, IsLeftDoubleWhereSingleHasNoSuchNumbers) {
  for (const double scale : {1e60, 1e-60}) {
    const SparseMatrix scaled = scale * lower_;
    FactorRoughly(scaled);
    EXPECT_LT(Error(scaled), 1e-12) << scale;
  }
}

TEST_F(SinglePrecisionFactorTest, WithoutAFactorNothingHappens) {
  cholesky_->KeepInSinglePrecision();
  FactorRoughly(lower_);
  EXPECT_LT(Error(lower_), 1e-5);
}

TEST(SinglePrecisionFactor, IllConditionedSystemsAreSolvedAllTheSame) {
  const SparseMatrix lower = GridMatrix(kSide, 1e-11);  // all but singular
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(lower.cols(), -1, 3);
  LaggedFactorization factor(MakeCholesky("cholmod"), 10);
  SolveSummary summary;
  Eigen::VectorXd x;
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(factor.Solve(lower, b, {1e-4}, &x, &summary));
    EXPECT_LT((lower.selfadjointView<Eigen::Lower>() * x - b).norm(), 1e-4 * b.norm());
  }
  EXPECT_LE(summary.factorizations, 2);
}

// Newton's method on an angle fit can lose its way where its first systems are solved loosely.
TEST(SinglePrecisionFactor, IsNotWhatItsOwnSystemIsSolvedWith) {
  const SparseMatrix lower = GridMatrix(kSide, 0.1, 0.5), other = GridMatrix(kSide, 0.1, 0.51);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(lower.cols(), -1, 3);
  LaggedFactorization factor(MakeCholesky("cholmod"), 10);
  SolveSummary summary;
  Eigen::VectorXd x;
  const auto residual = [&](const SparseMatrix& matrix) {
    EXPECT_TRUE(factor.Solve(matrix, b, {0.1}, &x, &summary));
    return (matrix.selfadjointView<Eigen::Lower>() * x - b).norm() / b.norm();
  };
  EXPECT_LT(residual(lower), 1e-13);
  EXPECT_EQ(summary.cg_iterations, 0);
  EXPECT_GT(residual(other), 1e-10);
  EXPECT_GT(summary.cg_iterations, 0);
  EXPECT_EQ(summary.factorizations, 1);
}

/// The factor of a grid, analysed only.
class SupernodalTreeTest : public ::testing::Test {
 protected:
  /// Of each supernode: the number of its subtrees among all groups', -1 in the top.
  std::vector<int> Places() const {
    std::vector<int> place(tree_.num_supernodes(), -2);
    int count = 0;
    for (const auto& group : tree_.groups()) {
      for (const auto& subtrees : group) {
        for (int s = subtrees.begin; s < subtrees.end; ++s) {
          EXPECT_EQ(place[s], -2) << "twice";
          place[s] = count;
        }
        ++count;
      }
    }
    for (const int s : tree_.top_supernodes()) place[s] = place[s] == -2 ? -1 : -3;
    return place;
  }

  AnalysedFactor analysed_{GridMatrix(kSide, 1)};
  const SupernodalTree tree_{analysed_.factor()};
};

TEST_F(SupernodalTreeTest, EverySupernodeHasOneGroupAndSubtreesDoNotSeeEachOther) {
  const std::vector<int> place = Places();
  std::vector<int> place_of_column(analysed_.factor().n);
  for (int s = 0; s < tree_.num_supernodes(); ++s) {
    ASSERT_GE(place[s], -1);
    for (int k = 0; k < tree_.NumColumns(s); ++k) {
      place_of_column[tree_.FirstColumn(s) + k] = place[s];
    }
  }
  for (int s = 0; s < tree_.num_supernodes(); ++s) {
    for (int k = 0; k < tree_.NumRows(s); ++k) {
      const bool near = k < tree_.NumNear(s);
      ASSERT_EQ(place_of_column[tree_.Rows(s)[k]], near ? place[s] : -1);
      ASSERT_EQ(tree_.TopNumber(tree_.Rows(s)[k]) >= 0, place[s] == -1 || !near);
    }
  }
}

TEST_F(SupernodalTreeTest, TheWorkIsDealtOutToManyGroupsAndLittleIsLeftForTheTop) {
  const auto work = [&](int s) { return double(tree_.NumRows(s)) * tree_.NumColumns(s); };
  double all = 0, of_top = 0, most = 0;
  for (int s = 0; s < tree_.num_supernodes(); ++s) all += work(s);
  for (const int s : tree_.top_supernodes()) of_top += work(s);
  for (const auto& group : tree_.groups()) {
    double of_group = 0;
    for (const auto& subtrees : group) {
      for (int s = subtrees.begin; s < subtrees.end; ++s) of_group += work(s);
    }
    most = std::max(most, of_group);
  }
  EXPECT_GT(most, 0);
  EXPECT_LT(most, 0.15 * all);
  EXPECT_LT(of_top, 0.4 * all);
}

}  // namespace
}  // namespace cirque

#endif  // CIRQUE_CHOLMOD

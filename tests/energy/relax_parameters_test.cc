#include "cirque/energy/relax_parameters.h"

#include <cmath>

#include <gtest/gtest.h>

namespace cirque {
namespace {

using Eigen::VectorXd;

/// 1/2 x'Ax + b.x with the tridiagonal A = tridiag(-1, 10, -1), its parameters relaxed from x = 0.
class RelaxParametersTest : public ::testing::Test {
 protected:
  bool Relax(double share) {
    gradient_ = b_;
    x_ = VectorXd::Zero(b_.size());
    moves_ = 0;
    const double threshold = share * b_.lpNorm<Eigen::Infinity>();
    return RelaxParameters(threshold, gradient_, [&](int i, const auto& change) {
      EXPECT_GT(std::abs(gradient_[i]), threshold) << "does not stand out";
      ++moves_;
      const double by = -gradient_[i] / 10;
      x_[i] += by;
      if (i > 0) change(i - 1, -by);
      change(i, 10 * by);
      if (i + 1 < b_.size()) change(i + 1, -by);
    });
  }

  /// A x + b.
  VectorXd GradientThere() const {
    VectorXd gradient = 10 * x_ + b_;
    gradient.head(b_.size() - 1) -= x_.tail(b_.size() - 1);
    gradient.tail(b_.size() - 1) -= x_.head(b_.size() - 1);
    return gradient;
  }

  VectorXd b_ = VectorXd::Constant(4000, 1e-6);
  VectorXd gradient_, x_;
  int moves_ = 0;
};

TEST_F(RelaxParametersTest, LeavesNothingAboveTheShare) {
  b_[70] = 2;
  b_[72] = 1;
  b_[300] = -3;
  int moves_before = 0;
  for (const double share : {0.5, 0.1, 1e-2, 1e-3}) {
    ASSERT_TRUE(Relax(share));
    EXPECT_LE(gradient_.lpNorm<Eigen::Infinity>(), share * 3);
    EXPECT_LT((gradient_ - GradientThere()).lpNorm<Eigen::Infinity>(), 1e-15);
    EXPECT_GT(moves_, moves_before) << "a smaller share takes more";
    moves_before = moves_;
  }
}

TEST_F(RelaxParametersTest, OneThatStandsOutAloneTakesOneMoveWhereTheShareAllowsIt) {
  b_[70] = 3;
  // A tenth of it goes to either neighbour.
  ASSERT_TRUE(Relax(0.2));
  EXPECT_EQ(moves_, 1);
  EXPECT_DOUBLE_EQ(x_[70], -0.3);
  EXPECT_DOUBLE_EQ(gradient_[69], 0.3 + 1e-6);
  ASSERT_TRUE(Relax(0.09));
  EXPECT_EQ(moves_, 3);
  EXPECT_LE(gradient_.lpNorm<Eigen::Infinity>(), 0.27);
}

TEST_F(RelaxParametersTest, DoesNothingWhereManyStandOut) {
  b_ = VectorXd::LinSpaced(4000, 1, 2);
  EXPECT_FALSE(Relax(0.1));
  EXPECT_EQ(moves_, 0);
  EXPECT_EQ(gradient_, b_);
  // The same entries, but by another share only the last few of them stand out.
  EXPECT_TRUE(Relax(0.995));
  EXPECT_GT(moves_, 0);
}

TEST_F(RelaxParametersTest, NothingStandsOutOfNothing) {
  b_.setZero();
  Relax(0.1);
  EXPECT_EQ(moves_, 0);
  EXPECT_EQ(gradient_, b_);
}

TEST(RelaxParameters, EndsWhereEveryMoveMakesAnother) {
  VectorXd gradient = VectorXd::Zero(1000);
  gradient[0] = 1;
  int moves = 0;
  EXPECT_TRUE(RelaxParameters(0.1, gradient, [&](int i, const auto& change) {
    ++moves;
    change(i, -1);
    change((i + 1) % 1000, 1);
  }));
  EXPECT_GT(moves, 1);
  EXPECT_LT(moves, 200);
  EXPECT_EQ(gradient[moves], 1) << "the moves made are not those told";
}

}  // namespace
}  // namespace cirque

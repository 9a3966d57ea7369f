// The small quadratic program of the curvatures: optimal, feasible or nothing.
#include "cirque/cones/curvature_program.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

namespace cirque {
namespace {

CurvatureProgram Random(int n, unsigned seed) {
  std::srand(seed);
  CurvatureProgram program;
  const Eigen::MatrixXd root = Eigen::MatrixXd::Random(n, n);
  program.gram = root.transpose() * root + 0.1 * Eigen::MatrixXd::Identity(n, n);
  program.linear = 2 * Eigen::VectorXd::Random(n);
  program.lower = -Eigen::VectorXd::Random(n).cwiseAbs();
  program.upper = Eigen::VectorXd::Random(n).cwiseAbs();
  return program;
}

double Value(const CurvatureProgram& program, const Eigen::VectorXd& mu) {
  return 0.5 * mu.dot(program.gram * mu) + program.linear.dot(mu);
}

/// Karush, Kuhn and Tucker: with the total's multiplier, the gradient is zero at free curvatures and
/// points outwards at bound ones.
void ExpectOptimal(const CurvatureProgram& program, const Eigen::VectorXd& mu) {
  EXPECT_GE((mu - program.lower).minCoeff(), 0);
  EXPECT_GE((program.upper - mu).minCoeff(), 0);
  if (program.total) {
    EXPECT_NEAR(mu.sum(), *program.total, 1e-10);
  }
  const Eigen::VectorXd gradient = program.gram * mu + program.linear;
  double least = -HUGE_VAL, greatest = HUGE_VAL;  // of the multiplier
  for (int i = 0; i < mu.size(); ++i) {
    if (mu[i] > program.lower[i]) least = std::max(least, gradient[i]);
    if (mu[i] < program.upper[i]) greatest = std::min(greatest, gradient[i]);
  }
  EXPECT_LE(least, greatest + 1e-9);
  if (!program.total) {
    EXPECT_LE(least, 1e-9);
    EXPECT_GE(greatest, -1e-9);
  }
}

TEST(CurvatureProgram, IsSolvedWithAndWithoutATotal) {
  int bound = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    CurvatureProgram program = Random(1 + seed % 7, seed);
    for (const bool has_total : {false, true}) {
      SCOPED_TRACE(seed);
      if (has_total) program.total = 0.7 * program.lower.sum() + 0.3 * program.upper.sum();
      const auto mu = Minimize(program);
      ASSERT_TRUE(mu);
      ExpectOptimal(program, *mu);
      bound += (mu->array() == program.lower.array()).any();
      // Where it starts does not matter.
      program.start = *mu;
      EXPECT_LT((*Minimize(program) - *mu).lpNorm<Eigen::Infinity>(), 1e-9);
      program.start = Eigen::VectorXd::Constant(mu->size(), 1e9);
      EXPECT_LT((*Minimize(program) - *mu).lpNorm<Eigen::Infinity>(), 1e-9);
    }
  }
  EXPECT_GT(bound, 10);
}

TEST(CurvatureProgram, NoFeasiblePointIsLower) {
  CurvatureProgram program = Random(3, 5);
  program.total = 0.5 * (program.lower.sum() + program.upper.sum());
  const double least = Value(program, *Minimize(program));
  for (int i = 0; i <= 20; ++i) {
    for (int j = 0; j <= 20; ++j) {
      Eigen::Vector3d mu;
      mu[0] = program.lower[0] + (program.upper[0] - program.lower[0]) * i / 20;
      mu[1] = program.lower[1] + (program.upper[1] - program.lower[1]) * j / 20;
      mu[2] = *program.total - mu[0] - mu[1];
      if (mu[2] < program.lower[2] || mu[2] > program.upper[2]) continue;
      EXPECT_GE(Value(program, mu), least - 1e-12);
    }
  }
}

TEST(CurvatureProgram, WhatBoundsExcludeHasNoSolution) {
  CurvatureProgram program = Random(4, 9);
  program.total = program.upper.sum() + 1e-3;
  EXPECT_FALSE(Minimize(program));
  program.total = program.lower.sum() - 1e-3;
  EXPECT_FALSE(Minimize(program));
  program.total = program.upper.sum();
  ASSERT_TRUE(Minimize(program));
  EXPECT_LT((*Minimize(program) - program.upper).lpNorm<Eigen::Infinity>(), 1e-12);
  program.total.reset();
  program.lower[2] = program.upper[2] + 1;
  EXPECT_FALSE(Minimize(program));
}

TEST(CurvatureProgram, NoConesCarryNothing) {
  CurvatureProgram none = Random(0, 1);
  ASSERT_TRUE(Minimize(none));
  EXPECT_EQ(Minimize(none)->size(), 0);
  none.total = 1;
  EXPECT_FALSE(Minimize(none));
}

}  // namespace
}  // namespace cirque

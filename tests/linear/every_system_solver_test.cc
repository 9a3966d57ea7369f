// What every way of solving one system after another must keep, beside dense factorisations.
#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "cirque/linear/amg_system_solver.h"
#include "cirque/linear/hermitian_cholesky.h"
#include "cirque/linear/lagged_factorization.h"
#include "cirque/linear/multigrid.h"
#include "cirque/linear/registry.h"

#include "tests/linear/grid_matrix.h"

namespace cirque {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd Dense(const SparseMatrix& lower) {
  return MatrixXd(lower).selfadjointView<Eigen::Lower>();
}

/// Repeatable, entries in [-1, 1].
VectorXd Noise(int n, unsigned seed) {
  std::mt19937 random(seed);
  VectorXd v(n);
  for (double& entry : v) entry = std::ldexp(static_cast<double>(random()), -31) - 1;
  return v;
}

/// P A P' as a lower triangle, order[i] the row of A that becomes row i.
SparseMatrix Permuted(const SparseMatrix& lower, const std::vector<int>& order) {
  std::vector<int> now(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) now[order[i]] = static_cast<int>(i);
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < lower.cols(); ++j) {
    for (SparseMatrix::InnerIterator entry(lower, j); entry; ++entry) {
      const int a = now[entry.row()], b = now[j];
      entries.emplace_back(std::max(a, b), std::min(a, b), entry.value());
    }
  }
  SparseMatrix permuted(lower.rows(), lower.cols());
  permuted.setFromTriplets(entries.begin(), entries.end());
  return permuted;
}

std::vector<int> Shuffled(int n) {
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::mt19937 random(3);
  for (int i = n - 1; i > 0; --i) std::swap(order[i], order[random() % (i + 1)]);
  return order;
}

class EveryFactorization : public ::testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<SparseCholesky> Make() const { return MakeCholesky(GetParam()); }
};

TEST_P(EveryFactorization, AgreesWithADenseOne) {
  const SparseMatrix lower = GridMatrix(15, 0.01, 5);
  const VectorXd b = Noise(static_cast<int>(lower.cols()), 1);
  const auto cholesky = Make();
  ASSERT_TRUE(cholesky->Factorize(lower));
  const VectorXd dense = Dense(lower).ldlt().solve(b);
  EXPECT_LT((cholesky->Solve(b) - dense).norm(), 1e-11 * dense.norm());
}

TEST_P(EveryFactorization, TheOrderOfTheUnknownsDoesNotMatter) {
  const SparseMatrix lower = GridMatrix(14, 0.1, 4);
  const auto n = static_cast<int>(lower.cols());
  const std::vector<int> order = Shuffled(n);
  const VectorXd b = Noise(n, 2);
  VectorXd b_permuted(n);
  for (int i = 0; i < n; ++i) b_permuted[i] = b[order[i]];
  const auto plain = Make(), permuted = Make();
  ASSERT_TRUE(plain->Factorize(lower));
  ASSERT_TRUE(permuted->Factorize(Permuted(lower, order)));
  const VectorXd x = plain->Solve(b), y = permuted->Solve(b_permuted);
  for (int i = 0; i < n; ++i) EXPECT_NEAR(y[i], x[order[i]], 1e-12 * x.norm());
}

TEST_P(EveryFactorization, ItsOrderingNamesEveryUnknownOnceAndCanBeSuggested) {
  const SparseMatrix lower = GridMatrix(10, 0.5, 1);
  const auto cholesky = Make();
  ASSERT_TRUE(cholesky->Factorize(lower));
  std::vector<int> order = cholesky->Ordering();
  const VectorXd b = Noise(static_cast<int>(lower.cols()), 4), x = cholesky->Solve(b);
  const auto other = Make();
  other->SuggestOrdering(order);
  ASSERT_TRUE(other->Factorize(lower));
  EXPECT_LT((other->Solve(b) - x).norm(), 1e-12 * x.norm());
  std::sort(order.begin(), order.end());
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], static_cast<int>(i));
}

TEST_P(EveryFactorization, InSinglePrecisionItIsAGoodPreconditioner) {
  const SparseMatrix lower = GridMatrix(16, 0.05, 3);
  const VectorXd b = Noise(static_cast<int>(lower.cols()), 5);
  const auto cholesky = Make();
  ASSERT_TRUE(cholesky->Factorize(lower));
  const VectorXd x = cholesky->Solve(b);
  cholesky->KeepInSinglePrecision();
  EXPECT_LT((cholesky->Solve(b) - x).norm(), 1e-4 * x.norm());
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryFactorization,
                         ::testing::ValuesIn(LinearSolvers().Names()));

/// The ways to solve one system after another.
struct SystemSolverCase {
  std::string name;
  std::function<std::unique_ptr<SystemSolver>()> make;
};

std::vector<SystemSolverCase> SystemSolvers() {
  std::vector<SystemSolverCase> cases = {
      {"LaggedFactorization",
       [] { return std::unique_ptr<SystemSolver>(new LaggedFactorization(MakeCholesky(), 20)); }}};
  if (BuiltWithMultigrid()) {
    cases.push_back({"Multigrid", [] {
                       return std::unique_ptr<SystemSolver>(new AmgSystemSolver(AmgOptions()));
                     }});
  }
  return cases;
}

class EverySystemSolver : public ::testing::TestWithParam<SystemSolverCase> {};

TEST_P(EverySystemSolver, MeetsTheToleranceOnASequenceThatDrifts) {
  const auto solver = GetParam().make();
  SolveSummary summary;
  SparseMatrix lower = GridMatrix(18, 0.2, 2);
  const auto n = static_cast<int>(lower.cols());
  for (int step = 0; step < 5; ++step) {
    const VectorXd b = Noise(n, 10 + step);
    VectorXd x;
    ASSERT_TRUE(solver->Solve(lower, b, {1e-9, 0.1}, &x, &summary));
    EXPECT_LE((Dense(lower) * x - b).norm(), 1e-8 * b.norm()) << step;
    for (int j = 0; j < n; ++j) DiagonalEntry(&lower, j) *= 1 + 0.02 * ((j + step) % 5);
  }
  EXPECT_GE(summary.linear_solves, 5);
  EXPECT_LE(summary.factorizations, 2) << "what changes little needs no factor of its own";
}

TEST_P(EverySystemSolver, ScalesWithTheRightSide) {
  const auto solver = GetParam().make();
  SolveSummary summary;
  const SparseMatrix lower = GridMatrix(12, 0.5, 1);
  const VectorXd b = Noise(static_cast<int>(lower.cols()), 7);
  VectorXd x, y;
  ASSERT_TRUE(solver->Solve(lower, b, {1e-11, 0.1}, &x, &summary));
  ASSERT_TRUE(solver->Solve(lower, -8 * b, {1e-11, 0.1}, &y, &summary));
  EXPECT_GT(x.norm(), 0.1);
  EXPECT_LT((y + 8 * x).norm(), 1e-8 * y.norm());
}

TEST_P(EverySystemSolver, PreparingChangesNoResult) {
  const SparseMatrix lower = GridMatrix(12, 0.5, 1);
  const VectorXd b = Noise(static_cast<int>(lower.cols()), 8);
  SolveSummary summary;
  VectorXd x, y;
  const auto plain = GetParam().make(), prepared = GetParam().make();
  ASSERT_TRUE(plain->Solve(lower, b, {1e-12, 0.1}, &x, &summary));
  prepared->Prepare(lower);
  ASSERT_TRUE(prepared->Solve(lower, b, {1e-12, 0.1}, &y, &summary));
  EXPECT_LT((x - y).norm(), 1e-10 * x.norm());
}

INSTANTIATE_TEST_SUITE_P(Kinds, EverySystemSolver, ::testing::ValuesIn(SystemSolvers()),
                         [](const auto& test) { return test.param.name; });

// A + iB Hermitian acts on (re, im) as the real symmetric matrix [A -B; B A].
TEST(HermitianCholesky, AgreesWithTheRealMatrixOfTwiceTheSize) {
  const SparseMatrix real = GridMatrix(6, 3, 1);
  const auto n = static_cast<int>(real.cols());
  ComplexSparseMatrix lower = real.cast<std::complex<double>>();
  MatrixXd b = MatrixXd::Zero(n, n);
  ForEachOffDiagonal(real, [&](int i, int j, int p) {
    const double turn = 0.5 * std::sin(i + 2 * j);
    lower.valuePtr()[p] += std::complex<double>(0, turn);
    b(i, j) = turn;
    b(j, i) = -turn;
  });
  MatrixXd twice(2 * n, 2 * n);
  twice << Dense(real), -b, b, Dense(real);
  const VectorXd right = Noise(2 * n, 9);
  const VectorXd dense = twice.ldlt().solve(right);
  HermitianCholesky cholesky;
  ASSERT_TRUE(cholesky.Factorize(lower));
  Eigen::VectorXcd complex_right(n);
  complex_right.real() = right.head(n);
  complex_right.imag() = right.tail(n);
  const Eigen::VectorXcd x = cholesky.Solve(complex_right);
  EXPECT_LT((x.real() - dense.head(n)).norm(), 1e-11 * dense.norm());
  EXPECT_LT((x.imag() - dense.tail(n)).norm(), 1e-11 * dense.norm());
}

}  // namespace
}  // namespace cirque

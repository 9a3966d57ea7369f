#include <cmath>

#include <gtest/gtest.h>

#include "cirque/math/compensated_sum.h"

namespace cirque {
namespace {

/// Large terms that cancel in pairs, and small ones between them that must survive.
double Term(int i) {
  constexpr double kSign[] = {1, 0, -1, 0};
  return i % 2 ? 1e-3 : kSign[i % 4] * std::ldexp(1.0, i / 4 % 40);
}

TEST(ParallelSum, KeepsWhatPlainSumsLose) {
  constexpr int kTerms = 40 * kParallelBlock;
  EXPECT_NEAR(ParallelSum(kTerms, Term), 1e-3 * kTerms / 2, 1e-9);
}

TEST(ParallelSum, IsTheSameForAnyNumberOfThreads) {
  constexpr int kTerms = 3 * kParallelBlock + 11;
  const auto term = [](int i) { return std::sin(i) * std::exp(i % 40); };
  const double many = ParallelSum(kTerms, term);
  const ThreadLimit one(1);
  EXPECT_EQ(ParallelSum(kTerms, term), many);
  EXPECT_NE(many, 0);
}

TEST(ParallelSum, AddsSumsWithWhatTheyLost) {
  CompensatedSum a, b;
  a += 1e16, a += 1.0;
  b += -1e16, b += 1.0;
  a += b;
  EXPECT_EQ(a.Value(), 2.0);
  EXPECT_EQ(ParallelSum(0, Term), 0);
}

}  // namespace
}  // namespace cirque

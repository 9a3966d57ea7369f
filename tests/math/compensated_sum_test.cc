#include "cirque/math/compensated_sum.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "experiments/common/high_precision.h"

namespace cirque {
namespace {

TEST(CompensatedSum, KeepsWhatKahanLoses) {
  CompensatedSum sum;
  for (const double x : {1.0, 1e100, 1.0, -1e100}) sum += x;
  EXPECT_EQ(sum.Value(), 2.0);
  sum -= 2.0;
  EXPECT_EQ(sum.Value(), 0.0);
}

TEST(CompensatedSum, AMillionCancellingTerms) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  CompensatedSum sum;
  double plain = 0.0;
  high_precision::Real exact = 0;
  for (int i = 0; i < 1000000; ++i) {
    const double x = std::ldexp(uniform(random), static_cast<int>(40.0 * uniform(random)));
    sum += x;
    plain += x;
    exact += x;
  }
  EXPECT_LT(high_precision::RelativeError(sum.Value(), exact), 1e-15);
  EXPECT_GT(high_precision::RelativeError(plain, exact), 1e-15);
}

TEST(CompensatedSum, InfinityStaysInfinite) {
  CompensatedSum sum;
  sum += std::numeric_limits<double>::infinity();
  sum += 1.0;
  EXPECT_EQ(sum.Value(), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace cirque

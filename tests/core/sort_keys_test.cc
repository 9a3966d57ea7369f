#include "cirque/core/sort_keys.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "cirque/core/parallel.h"

namespace cirque {
namespace {

using Keys = std::vector<std::pair<double, int>>;

/// So many keys of value(random number in [0, 1)), shuffled.
Keys Shuffled(int count, const std::function<double(double)>& value) {
  std::mt19937 random(3);
  Keys keys;
  for (int i = 0; i < count; ++i) keys.emplace_back(value(std::ldexp(double(random()), -32)), i);
  std::shuffle(keys.begin(), keys.end(), random);
  return keys;
}

void ExpectSorted(Keys keys) {
  Keys wanted = keys;
  std::sort(wanted.begin(), wanted.end());
  SortKeys(&keys);
  EXPECT_EQ(keys, wanted);
}

TEST(SortKeys, SortsByValueThenIndexWhateverTheValuesAre) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const int count : {0, 1, 2, 100, 257, 5000, 50000}) {
    ExpectSorted(Shuffled(count, [](double x) { return x; }));
    ExpectSorted(Shuffled(count, [](double x) { return std::floor(1000 * x) - 500; }));
    ExpectSorted(Shuffled(count, [](double x) { return std::exp(1000 * (x - 0.5)); }));
    ExpectSorted(Shuffled(count, [](double) { return 2.5; }));
    ExpectSorted(Shuffled(count, [](double x) { return x < 0.1 ? -kInfinity : 1 / (x - 0.5); }));
    ExpectSorted(Shuffled(count, [](double x) { return x < 1e-3 ? 1e-308 : 1 + x; }));
  }
}

TEST(SortKeys, BothZerosAreOneValue) {
  Keys keys;
  for (int i = 1000; i-- > 0;) keys.emplace_back(i % 2 == 0 ? 0.0 : -0.0, i);
  SortKeys(&keys);
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(keys[i].second, i);
}

TEST(SortKeys, DoesNotDependOnTheNumberOfThreads) {
  Keys keys = Shuffled(50000, [](double x) { return std::floor(300 * x); }), alone = keys;
  SortKeys(&keys);
  const ThreadLimit limit(1);
  SortKeys(&alone);
  EXPECT_TRUE(std::is_sorted(alone.begin(), alone.end()));
  EXPECT_EQ(keys, alone);
}

}  // namespace
}  // namespace cirque

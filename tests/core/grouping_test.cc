#include "cirque/core/grouping.h"

#include <algorithm>
#include <numeric>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cirque {
namespace {

using testing::ElementsAre;

std::vector<Index> RandomIndices(Index count, Index below, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Index> indices(count);
  for (Index& i : indices) i = static_cast<Index>(random() % below);
  return indices;
}

TEST(SortIntoBuckets, KnownBuckets) {
  const Buckets buckets = SortIntoBuckets({2, 0, 2, 3, 0}, 5);
  EXPECT_THAT(buckets.first, ElementsAre(0, 2, 2, 4, 5, 5));
  EXPECT_THAT(buckets.item, ElementsAre(1, 4, 0, 2, 3));
  EXPECT_THAT(SortIntoBuckets({}, 2).first, ElementsAre(0, 0, 0));
}

TEST(SortIntoBuckets, IsAStableSort) {
  const std::vector<Index> bucket = RandomIndices(3000, 40, 1);
  std::vector<Index> order = RandomIndices(2000, 3000, 2);  // not all, some twice
  const Buckets buckets = SortIntoBuckets(bucket, 40, order);
  for (Index b = 0; b < 40; ++b) {
    for (Index i = buckets.first[b]; i < buckets.first[b + 1]; ++i) {
      EXPECT_EQ(bucket[buckets.item[i]], b);
    }
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](Index i, Index j) { return bucket[i] < bucket[j]; });
  EXPECT_EQ(buckets.item, order);
}

TEST(DisjointSets, AgreeWithLabelsThatAreRewritten) {
  constexpr Index n = 200;
  DisjointSets sets(n);
  std::vector<Index> label(n);
  std::iota(label.begin(), label.end(), 0);
  const std::vector<Index> ends = RandomIndices(300, n, 3);
  for (std::size_t k = 0; k + 1 < ends.size(); k += 2) {
    const Index a = label[ends[k]], b = label[ends[k + 1]];
    EXPECT_EQ(sets.Unite(ends[k], ends[k + 1]), a != b);
    // The least element names the set.
    std::replace(label.begin(), label.end(), std::max(a, b), std::min(a, b));
    for (Index i = 0; i < n; ++i) ASSERT_EQ(sets.Find(i), label[i]);
  }
}

TEST(DisjointSets, LongChainsAreOneSet) {
  constexpr Index n = 100000;
  DisjointSets sets(n);
  for (Index i = n - 1; i > 0; --i) EXPECT_TRUE(sets.Unite(i, i - 1));
  EXPECT_FALSE(sets.Unite(0, n - 1));
  EXPECT_EQ(sets.Find(n - 1), 0);
}

}  // namespace
}  // namespace cirque

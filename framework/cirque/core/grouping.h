#pragma once

#include <numeric>
#include <utility>
#include <vector>

#include "cirque/core/types.h"

namespace cirque {

/// Indices in groups. Items in buckets: bucket b holds item[first[b] .. first[b + 1]).
struct Buckets {
  std::vector<Index> first;  ///< number of buckets + 1
  std::vector<Index> item;
};

/// The items of `order` in the buckets that `bucket_of` gives them: a stable counting sort, items
/// keep their order within each bucket. O(items + buckets).
inline Buckets SortIntoBuckets(const std::vector<Index>& bucket_of, Index num_buckets,
                               const std::vector<Index>& order) {
  Buckets buckets;
  buckets.first.assign(num_buckets + 1, 0);
  for (const Index item : order) ++buckets.first[bucket_of[item] + 1];
  std::partial_sum(buckets.first.begin(), buckets.first.end(), buckets.first.begin());
  std::vector<Index> next(buckets.first.begin(), buckets.first.end() - 1);
  buckets.item.resize(order.size());
  for (const Index item : order) buckets.item[next[bucket_of[item]]++] = item;
  return buckets;
}

/// The items 0, 1, ... in their buckets, in increasing order within each bucket.
inline Buckets SortIntoBuckets(const std::vector<Index>& bucket_of, Index num_buckets) {
  std::vector<Index> order(bucket_of.size());
  std::iota(order.begin(), order.end(), 0);
  return SortIntoBuckets(bucket_of, num_buckets, order);
}

/// Union-find over 0 .. n - 1. The representative of a set is its least element.
class DisjointSets {
 public:
  explicit DisjointSets(Index n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }

  Index Find(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  /// False when they were one set before.
  bool Unite(Index i, Index j) {
    i = Find(i);
    j = Find(j);
    if (i < j) std::swap(i, j);
    parent_[i] = j;
    return i != j;
  }

 private:
  std::vector<Index> parent_;
};

}  // namespace cirque

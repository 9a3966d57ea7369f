#include "cirque/core/counting_sort.h"

#include <numeric>

namespace cirque {

Buckets SortIntoBuckets(const std::vector<Index>& bucket_of, Index num_buckets) {
  std::vector<Index> order(bucket_of.size());
  std::iota(order.begin(), order.end(), 0);
  return SortIntoBuckets(bucket_of, num_buckets, order);
}

Buckets SortIntoBuckets(const std::vector<Index>& bucket_of, Index num_buckets,
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

}  // namespace cirque

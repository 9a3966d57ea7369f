#pragma once

#include <vector>

#include "cirque/core/types.h"

namespace cirque {

/// Items in buckets: bucket b holds item[first[b] .. first[b + 1]).
struct Buckets {
  std::vector<Index> first;  ///< number of buckets + 1
  std::vector<Index> item;
};

/// The items 0, 1, ... in the buckets that `bucket_of` gives them, in increasing order within each
/// bucket. O(items + buckets).
Buckets SortIntoBuckets(const std::vector<Index>& bucket_of, Index num_buckets);

/// The same for the items of `order`, which keep their order within each bucket (a stable sort).
Buckets SortIntoBuckets(const std::vector<Index>& bucket_of, Index num_buckets,
                        const std::vector<Index>& order);

}  // namespace cirque

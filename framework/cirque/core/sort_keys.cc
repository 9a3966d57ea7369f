#include "cirque/core/sort_keys.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "cirque/core/parallel.h"

namespace cirque {
namespace {

using Key = std::pair<double, int>;

constexpr std::size_t kFew = 256;     ///< keys that are sorted as they are
constexpr std::size_t kOfBucket = 4;  ///< keys, about

/// A number that grows with the value, as its logarithm does.
std::uint64_t Rank(double value) {
  constexpr std::uint64_t kSign = UINT64_C(1) << 63;
  const auto bits = std::bit_cast<std::uint64_t>(value + 0.0);  // of both zeros that of one
  return (bits & kSign) != 0 ? ~bits : bits | kSign;
}

/// Deals ranks between two into buckets by their leading bits.
class Dealer {
 public:
  explicit Dealer(const std::vector<Key>& keys) : least_(Rank(keys.front().first)) {
    std::uint64_t largest = least_;
    for (const Key& key : keys) {
      least_ = std::min(least_, Rank(key.first));
      largest = std::max(largest, Rank(key.first));
    }
    const int bits = static_cast<int>(std::bit_width(keys.size() / kOfBucket));
    shift_ = std::max(0, static_cast<int>(std::bit_width(largest - least_)) - bits);
    count_ = static_cast<int>((largest - least_) >> shift_) + 1;
  }

  int count() const { return count_; }
  int BucketOf(const Key& key) const {
    return static_cast<int>((Rank(key.first) - least_) >> shift_);
  }

 private:
  std::uint64_t least_;
  int shift_ = 0, count_ = 1;
};

/// Each key changes places with one that stands where it belongs, until all are in their buckets.
void Permute(const Dealer& dealer, const std::vector<int>& first, std::vector<Key>* keys) {
  std::vector<int> next(first.begin(), first.end() - 1);
  for (int b = 0; b < dealer.count(); ++b) {
    while (next[b] < first[b + 1]) {
      const int home = dealer.BucketOf((*keys)[next[b]]);
      if (home == b) {
        ++next[b];
      } else {
        std::swap((*keys)[next[b]], (*keys)[next[home]++]);
      }
    }
  }
}

}  // namespace

void SortKeys(std::vector<Key>* keys) {
  if (keys->size() <= kFew) return std::sort(keys->begin(), keys->end());
  const Dealer dealer(*keys);
  std::vector<int> first(dealer.count() + 1, 0);
  for (const Key& key : *keys) ++first[dealer.BucketOf(key) + 1];
  for (int b = 0; b < dealer.count(); ++b) first[b + 1] += first[b];
  Permute(dealer, first, keys);
  ParallelFor(dealer.count(), [&](int b) {
    if (first[b + 1] - first[b] > 1) {
      std::sort(keys->begin() + first[b], keys->begin() + first[b + 1]);
    }
  });
}

}  // namespace cirque

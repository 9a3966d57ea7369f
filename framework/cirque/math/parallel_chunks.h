#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "cirque/core/parallel.h"
#include "cirque/math/compensated_sum.h"

namespace cirque {

/// How many elements of a loop are put into small arrays for the functions that take such.
constexpr int kChunk = 128;

/// The values of such elements, `kEach` of every one, side by side: what functions of spans take.
template <class T = double, int kEach = 1>
class ChunkOf {
 public:
  explicit ChunkOf(int elements) : size_(kEach * static_cast<std::size_t>(elements)) {}

  T& operator[](std::size_t k) { return values_[k]; }
  const T& operator[](std::size_t k) const { return values_[k]; }
  std::size_t size() const { return size_; }
  T* data() { return values_.data(); }
  const T* data() const { return values_.data(); }
  T* begin() { return data(); }
  const T* begin() const { return data(); }
  T* end() { return data() + size_; }
  const T* end() const { return data() + size_; }

 private:
  std::array<T, kEach * kChunk> values_;
  std::size_t size_;
};

/// Calls body(first, end) for consecutive runs of [0, n) of at most kChunk, under the conditions of
/// ForEachBlock.
template <class Body>
void ParallelChunks(int n, const Body& body) {
  ForEachBlock(n, [&body](int, int begin, int end) {
    for (int i = begin; i < end; i += kChunk) body(i, std::min(end, i + kChunk));
  });
}

/// ParallelSum of what add(first, end, &sum) adds for these runs.
template <class Add>
double ParallelSumOfChunks(int n, const Add& add) {
  std::vector<CompensatedSum> of_block(NumBlocks(n));
  ForEachBlock(n, [&](int block, int begin, int end) {
    CompensatedSum sum;
    for (int i = begin; i < end; i += kChunk) add(i, std::min(end, i + kChunk), &sum);
    of_block[block] = sum;
  });
  CompensatedSum total;
  for (const CompensatedSum& sum : of_block) total += sum;
  return total.Value();
}

}  // namespace cirque

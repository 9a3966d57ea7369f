#pragma once

#include <algorithm>
#include <vector>

#include "cirque/core/parallel.h"
#include "cirque/math/compensated_sum.h"

namespace cirque {

/// How many elements of a loop are put into small arrays for the functions that take such.
constexpr int kChunk = 128;

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

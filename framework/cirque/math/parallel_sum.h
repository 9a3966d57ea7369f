#pragma once

#include <vector>

#include "cirque/core/parallel.h"
#include "cirque/math/compensated_sum.h"

namespace cirque {

/// sum_i term(i), i in [0, n), on all cores with the accuracy of CompensatedSum; the same whatever
/// the number of threads. Under the conditions of ForEachBlock.
template <class Term>
double ParallelSum(int n, const Term& term) {
  std::vector<CompensatedSum> of_block(NumBlocks(n));
  ForEachBlock(n, [&](int block, int begin, int end) {
    CompensatedSum sum;
    for (int i = begin; i < end; ++i) sum += term(i);
    of_block[block] = sum;
  });
  CompensatedSum total;
  for (const CompensatedSum& sum : of_block) total += sum;
  return total.Value();
}

}  // namespace cirque

#pragma once

#include <algorithm>
#include <vector>

#include "cirque/energy/energy.h"

namespace cirque {

/// Builds the lower triangle of an n x n matrix in place, without a list of triplets: the entries
/// are asked for twice, first to be counted, then to be filled in, and equal ones are added up in
/// the order they come. `for_each_entry(add)` calls add(i, j, value), i >= j, for every entry, both
/// times the same; each diagonal entry at least once.
template <class ForEachEntry>
void AssembleLower(int n, const ForEachEntry& for_each_entry, SparseMatrix* lower) {
  std::vector<int> first(n + 1, 0), size(n, 0);
  for_each_entry([&](int, int j, double) { ++first[j + 1]; });
  for (int j = 0; j < n; ++j) first[j + 1] += first[j];
  lower->resize(n, n);
  lower->resizeNonZeros(first[n]);
  int* row = lower->innerIndexPtr();
  double* value = lower->valuePtr();
  // Columns are short: each entry sinks to its place as it comes.
  for_each_entry([&](int i, int j, double x) {
    const int begin = first[j];
    int p = begin + size[j];
    while (p > begin && row[p - 1] > i) --p;
    if (p > begin && row[p - 1] == i) {
      value[p - 1] += x;
      return;
    }
    const int end = begin + size[j]++;
    std::copy_backward(row + p, row + end, row + end + 1);
    std::copy_backward(value + p, value + end, value + end + 1);
    row[p] = i;
    value[p] = x;
  });
  int used = 0;
  for (int j = 0; j < n; ++j) {
    lower->outerIndexPtr()[j] = used;
    std::copy(row + first[j], row + first[j] + size[j], row + used);
    std::copy(value + first[j], value + first[j] + size[j], value + used);
    used += size[j];
  }
  lower->outerIndexPtr()[n] = used;
  lower->resizeNonZeros(used);
}

}  // namespace cirque

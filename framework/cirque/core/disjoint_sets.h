#pragma once

#include <numeric>
#include <utility>
#include <vector>

#include "cirque/core/types.h"

namespace cirque {

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

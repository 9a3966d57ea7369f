#pragma once

#include <cmath>
#include <vector>

#include "cirque/core/parallel.h"

namespace cirque {

/// Neumaier's improvement of Kahan's sum: the error of Value() is a few ulp of the sum plus
/// n^2 2^-106 sum |x|, so that energies of a million terms keep all their digits.
/// Source: A. Neumaier, Rundungsfehleranalyse einiger Verfahren zur Summation endlicher Summen,
/// ZAMM 54 (1974).
class CompensatedSum {
 public:
  CompensatedSum& operator+=(double x) {
    const double sum = sum_ + x;
    // The smaller addend lost its low bits.
    lost_ += std::abs(sum_) >= std::abs(x) ? (sum_ - sum) + x : (x - sum) + sum_;
    sum_ = sum;
    return *this;
  }
  /// Adds another sum with what it lost.
  CompensatedSum& operator+=(const CompensatedSum& other) {
    *this += other.sum_;
    lost_ += other.lost_;
    return *this;
  }
  CompensatedSum& operator-=(double x) { return *this += -x; }

  /// Infinite or NaN as the plain sum would be.
  double Value() const { return std::isfinite(sum_) ? sum_ + lost_ : sum_; }

 private:
  double sum_ = 0.0;
  double lost_ = 0.0;
};

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

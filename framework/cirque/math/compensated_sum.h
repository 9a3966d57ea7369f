#pragma once

#include <cmath>

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

}  // namespace cirque

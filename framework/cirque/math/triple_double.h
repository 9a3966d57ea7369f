#pragma once

#include <cmath>

namespace cirque {

/// The sum of three doubles, each below an ulp of the one before: some 159 bits. Sums, differences and
/// products are off by some 2^-155 of the operands. (N. Fabiano, J.-M. Muller, J. Picot, "Algorithms for
/// triple-word arithmetic", IEEE Trans. Comput. 68, 2019, from D. Knuth's two-sum.)
struct TripleDouble {
  double high = 0, middle = 0, low = 0;

  constexpr TripleDouble() = default;
  constexpr TripleDouble(double value) : high(value) {}  // NOLINT: doubles are such numbers
  /// Of parts as they are.
  constexpr TripleDouble(double of_high, double of_middle, double of_low)
      : high(of_high), middle(of_middle), low(of_low) {}

  double Value() const { return high + (middle + low); }
};

/// a + b as a double and what that is off by, exactly.
struct TwoSum {
  double sum, rest;

  TwoSum(double a, double b) : sum(a + b) {
    const double of_b = sum - a;
    rest = (a - (sum - of_b)) + (b - of_b);
  }
};

/// The sum of three doubles, the first the largest.
inline TripleDouble SumOf(double a, double b, double c) {
  const TwoSum small(b, c), large(a, small.sum), between(large.rest, small.rest);
  return {large.sum, between.sum, between.rest};
}

/// Exactly.
inline TripleDouble SumOf(double a, double b) {
  const TwoSum exact(a, b);
  return {exact.sum, exact.rest, 0};
}

inline TripleDouble operator-(const TripleDouble& a) { return {-a.high, -a.middle, -a.low}; }

inline TripleDouble operator+(const TripleDouble& a, const TripleDouble& b) {
  const TwoSum high(a.high, b.high), middle(a.middle, b.middle), between(middle.sum, high.rest);
  return SumOf(high.sum, between.sum, a.low + b.low + middle.rest + between.rest);
}

inline TripleDouble operator-(const TripleDouble& a, const TripleDouble& b) { return a + (-b); }

TripleDouble operator*(const TripleDouble& a, const TripleDouble& b);

inline TripleDouble Half(const TripleDouble& a) {
  return {0.5 * a.high, 0.5 * a.middle, 0.5 * a.low};
}

inline bool operator<(const TripleDouble& a, const TripleDouble& b) {
  if (a.high != b.high) return a.high < b.high;
  return a.middle < b.middle || (a.middle == b.middle && a.low < b.low);
}

/// e^x and e^x - 1, relatively. @pre neither they nor x are beyond a double's range.
TripleDouble Exp(const TripleDouble& x);
TripleDouble Expm1(const TripleDouble& x);

/// The square root of a number that is not negative, and a quotient.
TripleDouble Sqrt(const TripleDouble& a);
TripleDouble operator/(const TripleDouble& a, const TripleDouble& b);

/// log(e^x + e^y), off by some 1e-46. @pre finite.
TripleDouble LogAddExp(const TripleDouble& x, const TripleDouble& y);

}  // namespace cirque

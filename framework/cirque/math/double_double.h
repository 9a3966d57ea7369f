#pragma once

#include <cmath>

namespace cirque {

/// The sum of two doubles, the second below half an ulp of the first: 106 bits. Sums and differences
/// are off by some 2^-104, relatively. (T. Dekker, "A floating-point technique for extending the
/// available precision", Numer. Math. 18, 1971; D. Knuth's two-sum.)
struct DoubleDouble {
  double high = 0, low = 0;

  DoubleDouble() = default;
  DoubleDouble(double value) : high(value) {}  // NOLINT: doubles are such numbers
  DoubleDouble(double large, double small) : high(large + small), low(small - (high - large)) {}

  double Value() const { return high + low; }
};

/// Exactly.
inline DoubleDouble SumOf(double a, double b) {
  const double sum = a + b, of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}

inline DoubleDouble operator-(const DoubleDouble& a) {
  DoubleDouble negative;
  negative.high = -a.high;
  negative.low = -a.low;
  return negative;
}

inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble high = SumOf(a.high, b.high), low = SumOf(a.low, b.low);
  const DoubleDouble sum(high.high, high.low + low.high);
  return {sum.high, sum.low + low.low};
}

inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + (-b); }

DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b);

inline DoubleDouble Half(const DoubleDouble& a) {
  DoubleDouble half;
  half.high = 0.5 * a.high;
  half.low = 0.5 * a.low;
  return half;
}

inline bool operator<(const DoubleDouble& a, const DoubleDouble& b) {
  return a.high < b.high || (a.high == b.high && a.low < b.low);
}

/// e^x and e^x - 1, relatively. @pre neither they nor x are beyond a double's range.
DoubleDouble Exp(const DoubleDouble& x);
DoubleDouble Expm1(const DoubleDouble& x);

/// The square root of a number that is not negative, and a quotient.
DoubleDouble Sqrt(const DoubleDouble& a);
DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b);

/// log(e^x + e^y), off by some 1e-31. @pre finite.
DoubleDouble LogAddExp(const DoubleDouble& x, const DoubleDouble& y);

}  // namespace cirque

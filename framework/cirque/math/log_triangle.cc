#include "cirque/math/log_triangle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cirque/core/types.h"

namespace cirque {
namespace {

constexpr double kLargestExponent = 700;
constexpr double kNextToOne = 1e-3;
constexpr double kLeastTangent = 1e-150;  ///< below it cotangents are taken as there

/// (a - b) / c of sides a >= b, with the differences of logarithms log a - log b and log b - log c.
double RelativeDifference(double a_over_b, double b_over_c) {
  if (a_over_b == 0) return 0;
  const double difference = std::expm1(a_over_b);  // (a - b) / b
  if (b_over_c < kLargestExponent && std::isfinite(difference)) {
    return difference * std::exp(b_over_c);
  }
  const double log_difference = std::isfinite(difference) ? std::log(difference) : a_over_b;
  return std::exp(log_difference + b_over_c);
}

/// t = (a - b) / c, and how much it is below 1.
struct Difference {
  double t, below_one;
};

Difference RelativeDifferenceOf(double a_over_b, double b_over_c) {
  const double t = RelativeDifference(a_over_b, b_over_c);
  return {t, 1 - t};
}

/// Next to 1 in three times the digits: 1 - t is as the square of the angles at the longest side.
Difference RelativeDifferenceOf(const TripleDouble& a_over_b, const TripleDouble& b_over_c) {
  const double t = RelativeDifference(a_over_b.Value(), b_over_c.Value());
  if (!(std::abs(1 - t) < kNextToOne) || !(b_over_c.high < kLargestExponent)) return {t, 1 - t};
  return {t, (TripleDouble(1) - Expm1(a_over_b) * Exp(b_over_c)).Value()};
}

/// As the header says, of sides a >= b >= c by the differences of their logarithms.
LogTriangle SolveSorted(int a, int b, int c, double a_over_b, double b_over_c,
                        const Difference& difference) {
  LogTriangle triangle;
  const auto [t, below_one] = difference;
  if (!(below_one > 0)) {
    triangle.half_tangent[a] = std::numeric_limits<double>::infinity();
    triangle.angle[a] = kPi;
    return triangle;
  }
  const double side_b = std::exp(-a_over_b), side_c = std::exp(-a_over_b - b_over_c);  // a = 1
  const double sum = 1 + side_b + side_c, excess = 1 + (side_b - side_c);
  const double q = std::sqrt(excess / sum), r = std::sqrt((1 + t) / below_one);
  triangle.proper = true;
  triangle.half_tangent[a] = q * r;
  triangle.half_tangent[b] = q / r;
  triangle.half_tangent[c] = side_c * std::sqrt(below_one * (1 + t)) / std::sqrt(sum * excess);
  for (int k = 0; k < 3; ++k) triangle.angle[k] = 2 * std::atan(triangle.half_tangent[k]);
  return triangle;
}

double Rounded(double x) { return x; }
double Rounded(const TripleDouble& x) { return x.Value(); }

template <class Number>
LogTriangle Solve(const std::array<Number, 3>& x) {
  int a = 0, b = 1, c = 2;  // the sides in falling order
  if (x[a] < x[b]) std::swap(a, b);
  if (x[b] < x[c]) std::swap(b, c);
  if (x[a] < x[b]) std::swap(a, b);
  const Number a_over_b = x[a] - x[b], b_over_c = x[b] - x[c];
  return SolveSorted(a, b, c, Rounded(a_over_b), Rounded(b_over_c),
                     RelativeDifferenceOf(a_over_b, b_over_c));
}

}  // namespace

double LogTriangle::Cotangent(int k) const {
  if (!proper) return 0;
  const double tangent = std::max(half_tangent[k], kLeastTangent);
  return 0.5 * (1 / tangent - tangent);
}

LogTriangle SolveLogTriangle(const std::array<double, 3>& x) { return Solve(x); }

LogTriangle SolveExtendedLogTriangle(const std::array<TripleDouble, 3>& x) { return Solve(x); }

double LogAddExp(double x, double y) {
  const double larger = std::max(x, y);
  return larger + std::log1p(std::exp(std::min(x, y) - larger));
}

}  // namespace cirque

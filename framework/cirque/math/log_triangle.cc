#include "cirque/math/log_triangle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cirque/core/types.h"

namespace cirque {
namespace {

constexpr double kLargestExponent = 700;
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

/// As the header says, of sides a >= b >= c by the differences of their logarithms.
LogTriangle SolveSorted(int a, int b, int c, double a_over_b, double b_over_c) {
  LogTriangle triangle;
  const double t = RelativeDifference(a_over_b, b_over_c);
  if (!(t < 1)) {
    triangle.half_tangent[a] = std::numeric_limits<double>::infinity();
    triangle.angle[a] = kPi;
    return triangle;
  }
  const double side_b = std::exp(-a_over_b), side_c = std::exp(-a_over_b - b_over_c);  // a = 1
  const double sum = 1 + side_b + side_c, excess = 1 + (side_b - side_c);
  const double q = std::sqrt(excess / sum), r = std::sqrt((1 + t) / (1 - t));
  triangle.proper = true;
  triangle.half_tangent[a] = q * r;
  triangle.half_tangent[b] = q / r;
  triangle.half_tangent[c] = side_c * std::sqrt((1 - t) * (1 + t)) / std::sqrt(sum * excess);
  for (int k = 0; k < 3; ++k) triangle.angle[k] = 2 * std::atan(triangle.half_tangent[k]);
  return triangle;
}

template <class Number, class Difference>
LogTriangle Solve(const std::array<Number, 3>& x, const Difference& difference) {
  int a = 0, b = 1, c = 2;  // the sides in falling order
  if (x[a] < x[b]) std::swap(a, b);
  if (x[b] < x[c]) std::swap(b, c);
  if (x[a] < x[b]) std::swap(a, b);
  return SolveSorted(a, b, c, difference(x[a], x[b]), difference(x[b], x[c]));
}

}  // namespace

double LogTriangle::Cotangent(int k) const {
  if (!proper) return 0;
  const double tangent = std::max(half_tangent[k], kLeastTangent);
  return 0.5 * (1 / tangent - tangent);
}

LogTriangle SolveLogTriangle(const std::array<double, 3>& x) {
  return Solve(x, [](double a, double b) { return a - b; });
}

LogTriangle SolveExtendedLogTriangle(const std::array<DoubleDouble, 3>& x) {
  return Solve(x, [](const DoubleDouble& a, const DoubleDouble& b) { return (a - b).Value(); });
}

double LogAddExp(double x, double y) {
  const double larger = std::max(x, y);
  return larger + std::log1p(std::exp(std::min(x, y) - larger));
}

}  // namespace cirque

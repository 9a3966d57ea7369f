#include "cirque/math/log_triangle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cirque/core/types.h"

namespace cirque {
namespace {

constexpr double kLargestExponent = 700;
constexpr double kLeastTangent = 1e-150;  ///< below it cotangents are taken as there

/// (a - b) / c of sides a >= b with their logarithms.
double RelativeDifference(double log_a, double log_b, double log_c) {
  if (log_a == log_b) return 0;
  const double difference = std::expm1(log_a - log_b);  // (a - b) / b
  const double exponent = log_b - log_c;
  if (exponent < kLargestExponent && std::isfinite(difference)) {
    return difference * std::exp(exponent);
  }
  const double log_difference = std::isfinite(difference) ? std::log(difference) : log_a - log_b;
  return std::exp(log_difference + exponent);
}

}  // namespace

double LogTriangle::Cotangent(int k) const {
  if (!proper) return 0;
  const double tangent = std::max(half_tangent[k], kLeastTangent);
  return 0.5 * (1 / tangent - tangent);
}

LogTriangle SolveLogTriangle(const std::array<double, 3>& x) {
  int a = 0, b = 1, c = 2;  // the sides in falling order
  if (x[a] < x[b]) std::swap(a, b);
  if (x[b] < x[c]) std::swap(b, c);
  if (x[a] < x[b]) std::swap(a, b);
  LogTriangle triangle;
  const double t = RelativeDifference(x[a], x[b], x[c]);
  if (!(t < 1)) {
    triangle.half_tangent[a] = std::numeric_limits<double>::infinity();
    triangle.angle[a] = kPi;
    return triangle;
  }
  const double side_b = std::exp(x[b] - x[a]), side_c = std::exp(x[c] - x[a]);  // a = 1
  const double sum = 1 + side_b + side_c, excess = 1 + (side_b - side_c);
  const double q = std::sqrt(excess / sum), r = std::sqrt((1 + t) / (1 - t));
  triangle.proper = true;
  triangle.half_tangent[a] = q * r;
  triangle.half_tangent[b] = q / r;
  triangle.half_tangent[c] = side_c * std::sqrt((1 - t) * (1 + t)) / std::sqrt(sum * excess);
  for (int k = 0; k < 3; ++k) triangle.angle[k] = 2 * std::atan(triangle.half_tangent[k]);
  return triangle;
}

double LogAddExp(double x, double y) {
  const double larger = std::max(x, y);
  return larger + std::log1p(std::exp(std::min(x, y) - larger));
}

}  // namespace cirque

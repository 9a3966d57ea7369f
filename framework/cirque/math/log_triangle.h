#pragma once

#include <array>

#include "cirque/math/triple_double.h"

namespace cirque {

/// A Euclidean triangle given by the logarithms of its sides: side k and corner k are opposite.
/// Where the sides violate the triangle inequality, the limit at the nearest degenerate triangle:
/// pi opposite the longest side, 0 elsewhere.
struct LogTriangle {
  bool proper = false;                   ///< the triangle inequality holds strictly
  std::array<double, 3> half_tangent{};  ///< tan(alpha / 2); improper: infinity and 0
  std::array<double, 3> angle{};         ///< alpha [rad]

  /// cot(alpha) of corner k; 0 in an improper triangle, whose angles are constant.
  double Cotangent(int k) const;
};

/// Solves it, for sides a >= b >= c with t = (a - b) / c by
///   tan^2(A/2) = (1 + t)/(1 - t) q^2,  tan^2(B/2) = (1 - t)/(1 + t) q^2,
///   tan(C/2) = c sqrt(1 - t^2) / sqrt((a + b + c)(a + b - c)),  q^2 = (a + b - c)/(a + b + c).
/// Differences of sides are taken as expm1 of differences of logarithms, and only ratios of sides
/// occur: no scale and no ratio of sides overflows, and needles keep their angles (after W. Kahan,
/// "Miscalculating Area and Angles of a Needle-like Triangle", 2014). Angles are off by no more than
/// what a change of the logarithms by an ulp does.
LogTriangle SolveLogTriangle(const std::array<double, 3>& log_side);

/// The same of needles whose long sides differ by less than an ulp of their logarithms, and of triangles
/// whose longest side is all but the sum of the others: 1 - t has three times the digits there.
LogTriangle SolveExtendedLogTriangle(const std::array<TripleDouble, 3>& log_side);

/// log(e^x + e^y).
double LogAddExp(double x, double y);

}  // namespace cirque

#pragma once

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// How far the prescribed angle sums are from what a flat metric needs [rad]: triangle sums add up
/// to pi F, so vertex sums must (Gauss-Bonnet: the curvatures 2 pi - Theta_v, pi - Theta_v on the
/// boundary, add up to 2 pi chi).
struct GaussBonnetDefect {
  double lower = 0;  ///< sum of the targets' lower ends minus pi F
  double upper = 0;  ///< sum of the targets' upper ends minus pi F

  /// Whether some choice within the intervals adds up, to within `tolerance` [rad].
  bool IsZeroPossible(double tolerance) const { return lower <= tolerance && upper >= -tolerance; }
};

/// The defect. Equals 2 pi chi when every vertex of a closed surface is
/// flat.
GaussBonnetDefect MeasureGaussBonnetDefect(const Triangulation& triangulation,
                                           const ConeTargets& targets);

}  // namespace cirque

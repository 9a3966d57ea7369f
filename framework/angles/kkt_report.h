#pragma once

#include <Eigen/Core>

#include "cirque/core/solve_summary.h"
#include "cirque/energy/angle_constraints.h"

namespace cirque {

/// How nearly angles satisfy the constraints and the optimality conditions of an angle fit; the
/// same for every fit, so that fits can be compared. Angles in radians.
struct KktReport {
  double triangle_sum_residual = kUnset;  ///< max_f |sum of the face's angles - pi|
  double vertex_sum_residual =
      kUnset;                      ///< max_v distance of the angle sum from its target interval
  double smallest_angle = kUnset;  ///< min alpha
  double smallest_theta =
      kUnset;  ///< min over edges of pi - alpha_l - alpha_r (boundary: pi - alpha)
  double primal = kUnset, dual = kUnset;  ///< objective and dual objective

  /// |primal - dual| / (1 + |primal|).
  double RelativeGap() const;
};

/// Fills in the four feasibility entries.
KktReport CheckFeasibility(const AngleConstraints& constraints, const Eigen::VectorXd& alpha);

}  // namespace cirque

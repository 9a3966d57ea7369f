#pragma once

#include <Eigen/Core>

#include "cirque/energy/angle_constraints.h"

namespace cirque {

/// Find coherent angles near reference angles: minimise an AngleObjective over
///   A alpha = b (triangle sums pi, vertex sums in their targets), alpha_e in Q_e(epsilon) for
///   every edge e.
struct AngleFitProblem {
  const AngleConstraints& constraints;
  const Eigen::VectorXd& reference;  ///< 3F [rad]
  double epsilon;                    ///< margin [rad]
};

}  // namespace cirque

#pragma once

#include <Eigen/Core>

#include "cirque/energy/angle_constraints.h"

namespace cirque {

/// Find coherent angles near reference angles: minimise an AngleObjective over
///   A alpha = b (triangle sums pi, vertex sums in their targets), alpha_e in Q_e(epsilon) for
///   every edge e.
struct AngleFitProblem {
  const AngleConstraints& constraints;
  const Eigen::VectorXd& reference;        ///< 3F [rad]
  double epsilon;                          ///< margin [rad]
  const Eigen::VectorXd* start = nullptr;  ///< multipliers near the solution's, of one row each;
                                           ///< null: 0. Methods need not use them
};

}  // namespace cirque

#pragma once

#include <Eigen/Core>

#include "cirque/core/infeasibility.h"
#include "cirque/energy/angle_constraints.h"

namespace cirque {

/// sum_f y_f + sum_v y_v (y_v > 0 ? lower_v : upper_v) - sum_e max over Q_e of (A'y)_e . a, in
/// units of pi: positive exactly when y proves that no coherent angles with this margin exist.
/// Homogeneous in y.
double InfeasibilityMargin(const AngleConstraints& constraints, double epsilon,
                           const Eigen::VectorXd& y);

/// Tries to turn multipliers along which the dual falls without bound into a proof: first one for
/// margin 0 (no coherent angles at all; rounding y to small integer multiples finds proofs that
/// hold with equality there), then one for `epsilon`. An empty proof means that y proves nothing.
InfeasibilityProof ProveInfeasible(const AngleConstraints& constraints, double epsilon,
                                   const Eigen::VectorXd& y);

}  // namespace cirque

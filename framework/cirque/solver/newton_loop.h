#pragma once

#include <functional>

#include <Eigen/Core>

#include "cirque/solver/regularization.h"
#include "cirque/solver/solve_run.h"

namespace cirque {

/// Finds a descent direction at x with this gradient, raising the shift as it must. False when
/// there is none.
using DirectionFinder =
    std::function<bool(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient,
                       HessianShift* shift, Eigen::VectorXd* direction)>;

/// The iteration that Newton's method and its relatives share: direction, line search, adaption of
/// the shift, records, limits.
void IterateNewton(const DirectionFinder& find_direction, SolveRun* run, Eigen::VectorXd* x);

}  // namespace cirque

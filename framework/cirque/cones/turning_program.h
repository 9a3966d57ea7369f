#pragma once

#include <optional>

#include <Eigen/Core>

#include "cirque/core/types.h"

namespace cirque {

/// How a closed curve turns at its n corners, and how it may: a small convex quadratic program,
///   minimise sum_k weight_k (x_k - turning_k)^2   over   lower_k <= x_k <= upper_k,
///   sum x = sum turning,   sum of x over every arc of corners >= -most_back.
/// A disk that is flat inside lies in the plane without overlap if no arc of its boundary turns back
/// by more than pi: W. Kaplan's criterion ("Close-to-convex schlicht functions", 1952; for circle
/// patterns in L. Kharevych's thesis, 2006). With most_back = 0 the curve is convex.
struct TurningProgram {
  Eigen::VectorXd turning;       ///< n [rad]; of positive sum, as once round a disk: 2 pi
  Eigen::VectorXd weight;        ///< n, > 0; 0 where a corner must turn as it does
  Eigen::VectorXd lower, upper;  ///< n [rad]
  double most_back = 0;          ///< [rad], >= 0
};

/// An arc of a closed curve: `count` corners from `first` on.
struct TurningArc {
  Index first = 0, count = 0;
  double turning = 0;  ///< [rad]
};

/// The arc that turns back farthest, O(n).
TurningArc DeepestArc(const Eigen::VectorXd& turning);

/// The minimiser to within 1e-7 rad; nothing where the bounds leave none, or none was found in time. Arcs enter where they are
/// violated, one at a time; between, coordinate ascent in the multipliers of arcs and sum (C.
/// Hildreth, "A quadratic programming procedure", 1957), whose x_k are those of the box in closed
/// form.
std::optional<Eigen::VectorXd> LeastTurning(const TurningProgram& program);

}  // namespace cirque

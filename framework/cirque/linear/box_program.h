#pragma once

#include <Eigen/Core>

#include "cirque/linear/sparse_matrix.h"

namespace cirque {

/// A sparse convex quadratic program in a box:
///   minimise 1/2 x' H x - b . x   over   |x_i| <= bound_i,
/// H positive semidefinite (n x n, its lower triangle), bound > 0.
struct BoxProgram {
  SparseMatrix hessian;
  Eigen::VectorXd linear, bound;
};

/// Its solution: H x - b = lower - upper with multipliers >= 0 that vanish inside the box.
struct BoxSolution {
  Eigen::VectorXd x, lower, upper;
  int factorizations = 0;
  bool converged = false;
  double complementarity = 0;  ///< largest multiplier times distance from its bound, relative
};

/// Primal-dual interior point with Mehrotra's predictor and corrector; one factorisation a step,
/// one symbolic analysis in all. Converged when the largest product of a multiplier with its
/// distance is at most `tolerance` times the largest |b_i| times the largest bound, and the largest
/// error of the equation at most `tolerance` times the largest |b_i|: no exact equality.
BoxSolution SolveBoxProgram(const BoxProgram& program, double tolerance = 1e-9);

}  // namespace cirque

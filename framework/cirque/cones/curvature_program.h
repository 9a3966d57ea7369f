#pragma once

#include <optional>

#include <Eigen/Core>

namespace cirque {

/// A small convex quadratic program over the curvatures mu of n cones:
///   minimise 1/2 mu' gram mu + linear . mu   over   lower <= mu <= upper,
/// and sum mu = total where a total is given.
struct CurvatureProgram {
  Eigen::MatrixXd gram;  ///< n x n, positive definite
  Eigen::VectorXd linear, lower, upper;
  std::optional<double> total;
  Eigen::VectorXd start;  ///< near the minimiser, if known: used where it is feasible
};

/// Its minimiser by a primal active-set method from a feasible point, O(n^3) a step; nothing when
/// the bounds leave no feasible point.
std::optional<Eigen::VectorXd> Minimize(const CurvatureProgram& program);

}  // namespace cirque

#pragma once

#include <Eigen/Core>

#include "cirque/cones/boundary_problem.h"

namespace cirque {

/// The log scales b at the open boundary vertices (V, 0 elsewhere) that minimise the convex function
///   f(b) = 1/p sum_v a_v |u_v|^p + filter/2 sum len_ij^2 (b_i - b_j)^2,      u = u_0 + H b,
/// a_v the areas of total 1, the second sum over the boundary edges between open vertices with the
/// lengths of a surface of area 1: without it b follows the noise of the linear model. Newton's method
/// with halvings through p = 2, 4, 8, ..., its systems by conjugate gradients on products with H and
/// H' (nothing squared is assembled: that loses digits of Gauss-Bonnet). @pre power is at least 2.
Eigen::VectorXd LeastNormLogScale(const BoundaryProblem& problem, int power, double filter);

/// The Newton step of that function where its gradient by b is given, as by a finished metric whose
/// log scales at the vertices are u: V, 0 but at the open boundary vertices.
Eigen::VectorXd LogScaleStep(const BoundaryProblem& problem, int power, double filter,
                             const Eigen::VectorXd& u, const Eigen::VectorXd& gradient);

}  // namespace cirque

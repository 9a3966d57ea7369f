#pragma once

#include <functional>

#include <Eigen/Core>

#include "cirque/linear/sparse_matrix.h"

namespace cirque {

/// An approximate inverse: x for a right side b, in the memory that x has. b is not x.
using Preconditioner = std::function<void(const Eigen::VectorXd& b, Eigen::VectorXd* x)>;

/// y = A x, in the memory that y has. x is not y.
using LinearOperator = std::function<void(const Eigen::VectorXd& x, Eigen::VectorXd* y)>;

/// a.b, of vectors of which this process may have a part only.
using InnerProduct = std::function<double(const Eigen::VectorXd& a, const Eigen::VectorXd& b)>;

/// That of whole vectors, the same whatever the number of threads.
double Dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b);

/// What a run of conjugate gradients achieved.
struct CgResult {
  int iterations = 0;
  bool converged = false;  ///< |A x - b| <= tolerance |b|
  bool positive = true;    ///< no direction of non-positive curvature was met
};

/// Solves A x = b by preconditioned conjugate gradients from x = 0, A by its lower triangle
/// (Hestenes & Stiefel 1952; Saad, Iterative methods, alg. 9.1). The preconditioner may vary a
/// little from one iteration to the next, as an iterative solve of its own does (flexible: Notay,
/// SIAM J. Sci. Comput. 22, 2000). Gives up early where the residual falls too slowly to reach its
/// target within max_iterations.
CgResult ConjugateGradients(const SparseMatrix& lower, const Eigen::VectorXd& right_side,
                            const Preconditioner& precondition, double tolerance,
                            int max_iterations, Eigen::VectorXd* x);

/// The same for a symmetric operator that is known by what it does; on several processes at once
/// with the inner product of all their parts.
CgResult ConjugateGradients(const LinearOperator& apply, const Eigen::VectorXd& right_side,
                            const Preconditioner& precondition, double tolerance,
                            int max_iterations, Eigen::VectorXd* x, const InnerProduct& dot = Dot);

}  // namespace cirque

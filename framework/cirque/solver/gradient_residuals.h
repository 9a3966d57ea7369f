#pragma once

#include <Eigen/Core>
#include <ceres/problem.h>

#include "cirque/energy/energy.h"
#include "cirque/solver/solve_run.h"

namespace cirque {

/// Poses grad E(x) = 0 as least squares, for any energy: one residual dE/dx_i a parameter, its
/// Jacobian the Hessian's row i. J'J is then the Hessian squared, which is why docs/mathematics.md
/// (Radii, Least squares) advises against it; it is here to be compared with exact residuals.
class GradientResiduals {
 public:
  /// `energy` and `run`, which counts the evaluations, must outlive this.
  GradientResiduals(const Energy& energy, SolveRun* run) : energy_(energy), run_(run) {}

  /// Evaluates at x; what the residual blocks then return. True unless the Hessian has entries that
  /// the blocks do not know, as a semi-smooth energy's may: then add the blocks to a new problem.
  bool Update(const Eigen::VectorXd& x, bool with_jacobian);

  /// Adds the blocks with all entries met so far and holds the gauge parameters constant. This must
  /// outlive the problem. @pre Update with Jacobian at x.
  void AddTo(double* x, ceres::Problem* problem);

 private:
  class Row;

  const Energy& energy_;
  SolveRun* run_;
  bool is_defined_ = false;
  Eigen::VectorXd gradient_;
  SparseMatrix lower_;
  SparseMatrix hessian_;  ///< both triangles, on the union of all patterns met
  SparseMatrix pattern_;  ///< that union, all zeros
};

}  // namespace cirque

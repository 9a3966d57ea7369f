#pragma once

#include <Eigen/Core>

#include "cirque/linear/system_solver.h"
#include "cirque/solver/newton_loop.h"
#include "cirque/solver/solver_strategy.h"

namespace cirque {

/// What every strategy on IterateInexactNewton has.
struct InexactNewtonOptions : SolverLimits {
  double forcing = 0.01;  ///< relative residual of the first steps' linear systems
};

/// Newton's systems, one after another.
class NewtonSystems {
 public:
  virtual ~NewtonSystems() = default;

  /// Turns to the Hessian at x, damped. False outside the domain.
  virtual bool Linearize(const Eigen::VectorXd& x, LevenbergMarquardtDamping* damping) = 0;

  /// Damps it more. False when that would be of no use.
  virtual bool Raise(LevenbergMarquardtDamping* damping) = 0;

  /// False where the matrix is not positive definite, or not solved.
  virtual bool Solve(const Eigen::VectorXd& right_side, const SolveAccuracy& accuracy,
                     Eigen::VectorXd* direction) = 0;
};

/// Newton's method whose linear systems are solved as tightly as superlinear convergence needs
/// (Eisenstat & Walker 1996, choice 2): relative residual min(forcing, |g| / |g_before| squared),
/// but `forcing` in the first step, and where that allows not below 1e-4 or what the solve's
/// gradient tolerance asks for. The last step may go by the Hessian before (ChordTest).
void IterateInexactNewton(double forcing, NewtonSystems* systems, SolveRun* run,
                          Eigen::VectorXd* x);

/// The same by `solver`, of an energy that this process has whole.
void IterateInexactNewton(double forcing, SystemSolver* solver, SolveRun* run, Eigen::VectorXd* x);

}  // namespace cirque

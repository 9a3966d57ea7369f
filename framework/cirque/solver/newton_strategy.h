#pragma once

#include <string>

#include "cirque/linear/registry.h"
#include "cirque/solver/solver_strategy.h"

namespace cirque {

struct NewtonOptions : SolverLimits {
  std::string linear_solver;  ///< a name of LinearSolvers(); empty: its first
};

const OptionTable<NewtonOptions>& NewtonOptionTable();

/// Newton's method with a sparse Cholesky factorisation a step and a line search on directional
/// derivatives. Semi-smooth energies whose generalised Hessian can be singular are regularised as
/// Levenberg and Marquardt do: a multiple of the identity that grows 100-fold (to at least 1e-5)
/// when steps below 1/100 are wanted or the factorisation fails, and shrinks again after full
/// steps. At kinks the method is orthant-wise: see Kinks.
class NewtonStrategy final : public SolverStrategy {
 public:
  explicit NewtonStrategy(const NewtonOptions& options) : options_(options) {}
  SolveSummary Minimize(const Energy& energy, const SolveControl& control,
                        Eigen::VectorXd* x) const override;

 private:
  NewtonOptions options_;
};

}  // namespace cirque

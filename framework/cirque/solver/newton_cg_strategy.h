#pragma once

#include <string>

#include "cirque/solver/solver_strategy.h"

namespace cirque {

struct NewtonCgOptions : SolverLimits {
  std::string linear_solver;   ///< a name of LinearSolvers(); empty: its first
  int max_cg_iterations = 12;  ///< a step: beyond, factoring anew is taken to be cheaper
  double forcing = 0.01;       ///< relative residual of the first steps' linear systems
};

const OptionTable<NewtonCgOptions>& NewtonCgOptionTable();

/// Newton's method whose linear systems are solved by conjugate gradients, preconditioned with the
/// factor of an earlier Hessian: one factorisation where Newton takes one a step
/// (IterateInexactNewton, ReusedFactor). Factors anew when conjugate gradients need more than
/// max_cg_iterations, or would on the whole way to the gradient tolerance.
class NewtonCgStrategy final : public SolverStrategy {
 public:
  explicit NewtonCgStrategy(const NewtonCgOptions& options) : options_(options) {}
  SolveSummary Minimize(const Energy& energy, const SolveControl& control,
                        Eigen::VectorXd* x) const override;

 private:
  NewtonCgOptions options_;
};

}  // namespace cirque

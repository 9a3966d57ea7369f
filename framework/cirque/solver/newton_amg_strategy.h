#pragma once

#include "cirque/linear/amg_system_solver.h"
#include "cirque/solver/solver_strategy.h"

namespace cirque {

struct NewtonAmgOptions : SolverLimits, AmgOptions {
  double forcing = 0.01;  ///< relative residual of the first steps' linear systems
};

const OptionTable<NewtonAmgOptions>& NewtonAmgOptionTable();

/// Newton's method whose linear systems are solved by conjugate gradients, preconditioned with
/// algebraic multigrid (IterateInexactNewton, AmgSystemSolver): time and memory proportional to the
/// unknowns on the Laplacians of circle patterns. By PETSc (Balay et al., PETSc/TAO users manual,
/// ANL-21/39) with hypre's BoomerAMG (Henson & Yang, Appl. Numer. Math. 41, 2002) or its own GAMG,
/// on one process or on all that mpirun has started (ServeOtherRanks). The summary counts
/// hierarchies as factorizations and multigrid cycles as linear solves; its message and its
/// strategy say when systems had to be factored after all.
class NewtonAmgStrategy final : public SolverStrategy {
 public:
  explicit NewtonAmgStrategy(const NewtonAmgOptions& options) : options_(options) {}
  SolveSummary Minimize(const Energy& energy, const SolveControl& control,
                        Eigen::VectorXd* x) const override;
  std::unique_ptr<SystemSolver> MakeSystemSolver(int num_unknowns) const override;

 private:
  NewtonAmgOptions options_;
};

}  // namespace cirque

#pragma once

#include <string>
#include <vector>

#include "cirque/core/option_table.h"
#include "cirque/linear/amg_system_solver.h"
#include "cirque/linear/system_solver.h"
#include "cirque/solver/solve_run.h"
#include "cirque/solver/solver_strategy.h"

namespace cirque {

/// The rows of an option table for what every strategy on IterateInexactNewton has.
template <class T>
std::vector<Option<T>> InexactNewtonOptions(const std::string& cg_limit_help) {
  return {Option<T>("max_cg_iterations", &T::max_cg_iterations, cg_limit_help).Between(1, 1e6),
          Option<T>("forcing", &T::forcing, "relative residual of the first steps' linear systems")
              .Between(1e-10, 0.9)};
}

/// Newton's method whose linear systems `solver` solves as tightly as superlinear convergence needs
/// (Eisenstat & Walker 1996, choice 2): relative residual min(forcing, |g| / |g_before| squared),
/// but `forcing` in the first step, and where that allows not below 1e-4 or what the solve's
/// gradient tolerance asks for.
void IterateInexactNewton(double forcing, SystemSolver* solver, SolveRun* run, Eigen::VectorXd* x);

struct NewtonCgOptions : SolverLimits {
  std::string linear_solver;   ///< a name of LinearSolvers(); empty: its first
  int max_cg_iterations = 12;  ///< a step: beyond, factoring anew is taken to be cheaper
  double forcing = 0.01;       ///< relative residual of the first steps' linear systems
};

const OptionTable<NewtonCgOptions>& NewtonCgOptionTable();

/// Newton's method whose linear systems are solved by conjugate gradients, preconditioned with the
/// factor of an earlier Hessian: one factorisation where Newton takes one a step
/// (IterateInexactNewton, LaggedFactorization). Factors anew when conjugate gradients need more than
/// max_cg_iterations, or would on the whole way to the gradient tolerance.
class NewtonCgStrategy final : public SolverStrategy {
 public:
  explicit NewtonCgStrategy(const NewtonCgOptions& options) : options_(options) {}
  SolveSummary Minimize(const Energy& energy, const SolveControl& control,
                        Eigen::VectorXd* x) const override;

 private:
  NewtonCgOptions options_;
};

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

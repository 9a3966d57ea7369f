#pragma once

#include <string>
#include <vector>

#include "cirque/core/option_table.h"
#include "cirque/linear/amg_system_solver.h"
#include "cirque/linear/system_solver.h"
#include "cirque/solver/energy_on_ranks.h"
#include "cirque/solver/inexact_newton.h"
#include "cirque/solver/solve_run.h"
#include "cirque/solver/solver_strategy.h"

namespace cirque {

struct NewtonOptions : SolverLimits {
  std::string linear_solver;  ///< a name of LinearSolvers(); empty: its first
};

const OptionTable<NewtonOptions>& NewtonOptionTable();

/// Newton's method with a sparse Cholesky factorisation a step (but for a last one that ChordTest leaves
/// to the factor before) and a line search on directional
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

struct NewtonCgOptions : InexactNewtonOptions {
  std::string linear_solver;   ///< a name of LinearSolvers(); empty: its first
  int max_cg_iterations = 12;  ///< a step: beyond, factoring anew is taken to be cheaper
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

struct NewtonAmgOptions : InexactNewtonOptions, AmgOptions {};

const OptionTable<NewtonAmgOptions>& NewtonAmgOptionTable();

/// Newton's method whose linear systems are solved by conjugate gradients, preconditioned with
/// algebraic multigrid (IterateInexactNewton, AmgSystemSolver): time and memory proportional to the
/// unknowns on the Laplacians of circle patterns. By PETSc (Balay et al., PETSc/TAO users manual,
/// ANL-21/39) with hypre's BoomerAMG (Henson & Yang, Appl. Numer. Math. 41, 2002) or its own GAMG,
/// on one process or on all that mpirun has started (ServeOtherRanks): energies with a source() are
/// then taken in parts (EnergyOnRanks). The summary counts hierarchies as factorizations and multigrid cycles as linear solves; its message and its
/// strategy say when systems had to be factored after all.
class NewtonAmgStrategy final : public SolverStrategy {
 public:
  explicit NewtonAmgStrategy(const NewtonAmgOptions& options) : options_(options) {}
  SolveSummary Minimize(const Energy& energy, const SolveControl& control,
                        Eigen::VectorXd* x) const override;
  std::unique_ptr<SystemSolver> MakeSystemSolver(int num_unknowns) const override;
  std::unique_ptr<EnergyOnRanks> TakeToRanks(const EnergySource& source) const override;

 private:
  /// With the systems of an energy that is whole.
  SolveSummary MinimizeWhole(const Energy& energy, const SolveControl& control,
                             Eigen::VectorXd* x) const;

  NewtonAmgOptions options_;
};

const OptionTable<SolverLimits>& AutoOptionTable();

/// Chooses a Newton strategy by what is at hand, and says in the summary which and why:
/// - newton_amg, if Cirque was built with PETSc, for 20 million unknowns or more: it takes less
///   memory than a factor;
/// - newton for fewer than 20,000 unknowns when the caller brings no factor: exact steps are cheap;
/// - newton_cg otherwise: one factor serves most steps, also where the Hessian changes abruptly in
///   places (an angle fit's active edges).
class AutoStrategy final : public SolverStrategy {
 public:
  explicit AutoStrategy(const SolverLimits& limits) : limits_(limits) {}
  SolveSummary Minimize(const Energy& energy, const SolveControl& control,
                        Eigen::VectorXd* x) const override;
  std::unique_ptr<SystemSolver> MakeSystemSolver(int num_unknowns) const override;
  std::unique_ptr<EnergyOnRanks> TakeToRanks(const EnergySource& source) const override;

 private:
  SolverLimits limits_;
};

}  // namespace cirque

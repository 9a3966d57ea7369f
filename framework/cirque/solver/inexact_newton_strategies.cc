#include <utility>

#include <fmt/format.h>

#include "cirque/linear/lagged_factorization.h"
#include "cirque/linear/registry.h"
#include "cirque/solver/newton_strategies.h"

namespace cirque {
namespace {

/// A strategy's table: the limits, the option of its own, and those of all inexact Newton methods.
template <class O>
OptionTable<O> TableOf(const std::string& strategy, const Option<O>& own,
                       const std::string& cg_limit_help) {
  auto options = Joined<O>(LimitOptions<O>(), {own});
  return OptionTable<O>(
      strategy,
      Joined<O>(
          std::move(options),
          {Option<O>("max_cg_iterations", &O::max_cg_iterations, cg_limit_help).Between(1, 1e6),
           Option<O>("forcing", &O::forcing, "relative residual of the first steps' linear systems")
               .Between(1e-10, 0.9)}));
}

}  // namespace

const OptionTable<NewtonCgOptions>& NewtonCgOptionTable() {
  using O = NewtonCgOptions;
  static const auto kTable = TableOf<O>(
      "newton_cg",
      Option<O>("linear_solver", &O::linear_solver, "sparse Cholesky; default: the first")
          .OneOf(LinearSolvers().Names()),
      "conjugate gradient iterations a step before factoring anew");
  return kTable;
}

SolveSummary NewtonCgStrategy::Minimize(const Energy& energy, const SolveControl& control,
                                        Eigen::VectorXd* x) const {
  SolveRun run("newton_cg", options_, control, energy);
  LaggedFactorization own(MakeCholesky(options_.linear_solver), options_.max_cg_iterations);
  SystemSolver* solver = control.system_solver ? control.system_solver : &own;
  IterateInexactNewton(options_.forcing, solver, &run, x);
  return run.Finish(*x);
}

const OptionTable<NewtonAmgOptions>& NewtonAmgOptionTable() {
  using O = NewtonAmgOptions;
  static const auto kTable = TableOf<O>(
      "newton_amg",
      Option<O>("multigrid", &O::multigrid, "the method; default: boomeramg where PETSc has hypre")
          .OneOf({"boomeramg", "gamg"}),
      "conjugate gradient iterations a system before factoring it");
  return kTable;
}

SolveSummary NewtonAmgStrategy::Minimize(const Energy& energy, const SolveControl& control,
                                         Eigen::VectorXd* x) const {
  if (const auto* on_ranks = dynamic_cast<const EnergyOnRanks*>(&energy)) {
    return on_ranks->Minimize(options_, control, x);
  }
  const EnergySource* source = control.system_solver ? nullptr : energy.source();
  if (const auto on_ranks = source ? TakeToRanks(*source) : nullptr) {
    SolveSummary summary = on_ranks->Minimize(options_, control, x);
    if (!on_ranks->failed()) return summary;
  }
  return MinimizeWhole(energy, control, x);
}

SolveSummary NewtonAmgStrategy::MinimizeWhole(const Energy& energy, const SolveControl& control,
                                              Eigen::VectorXd* x) const {
  SolveRun run("newton_amg", options_, control, energy);
  AmgSystemSolver own(options_);
  SystemSolver* solver = control.system_solver ? control.system_solver : &own;
  if (SparseMatrix smooth; !control.system_solver && energy.SmoothHessian(x->data(), &smooth)) {
    LevenbergMarquardtDamping(energy).DampHessian(&smooth);
    own.PrepareForSystemsNear(smooth, &run.summary());
  }
  IterateInexactNewton(options_.forcing, solver, &run, x);
  SolveSummary summary = run.Finish(*x);
  if (const std::string remark = solver->Remark(); !remark.empty()) {
    summary.message += "; " + remark;
    summary.strategy += ", " + remark;
  }
  return summary;
}

std::unique_ptr<SystemSolver> NewtonAmgStrategy::MakeSystemSolver(int) const {
  return std::make_unique<AmgSystemSolver>(options_);
}

std::unique_ptr<EnergyOnRanks> NewtonAmgStrategy::TakeToRanks(const EnergySource& source) const {
  return EnergyOnRanks::Make(source, options_);
}

}  // namespace cirque

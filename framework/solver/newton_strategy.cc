#include "cirque/solver/newton_strategy.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "cirque/solver/line_search.h"
#include "cirque/solver/regularization.h"
#include "cirque/solver/solve_run.h"
#include "cirque/solver/sparse_cholesky.h"

namespace cirque {
namespace {

constexpr int kMaxShiftsPerStep = 12;

/// Factors the regularised Hessian, raising the shift until it is positive definite, and solves for the step.
bool NewtonDirection(const Eigen::VectorXd& gradient, const SparseMatrix& hessian,
                     HessianShift* shift, SparseCholesky* cholesky, SolveSummary* summary,
                     Eigen::VectorXd* direction) {
  for (int attempt = 0; attempt < kMaxShiftsPerStep; ++attempt) {
    const Timer factor_timer;
    const bool factored = cholesky->Factorize(shift->Apply(hessian));
    summary->factorization_seconds += factor_timer.Seconds();
    if (factored) {
      const Timer solve_timer;
      *direction = -cholesky->Solve(gradient);
      ++summary->linear_solves;
      summary->solve_seconds += solve_timer.Seconds();
      if (direction->allFinite() && direction->dot(gradient) < 0) return true;
    }
    shift->Raise();
  }
  return false;
}

}  // namespace

const OptionTable<NewtonOptions>& NewtonOptionTable() {
  static const OptionTable<NewtonOptions> table("newton", [] {
    auto fields = LimitFields<NewtonOptions>();
    fields.push_back({"linear_solver", &NewtonOptions::linear_solver, 0, 0,
                      LinearSolvers().Names(), "sparse Cholesky; default: the first"});
    return fields;
  }());
  return table;
}

SolveSummary NewtonStrategy::Minimize(const Energy& energy, const SolveControl& control,
                                      Eigen::VectorXd* x) const {
  SolveRun run("newton", options_, control, energy);
  const auto solver = LinearSolvers().Find(options_.linear_solver);
  const std::unique_ptr<SparseCholesky> cholesky = solver.ok() ? (*solver)() : MakeDefaultCholesky();
  HessianShift shift(energy);
  Eigen::VectorXd gradient, direction;
  SparseMatrix hessian;
  if (!run.Begin(*x, &gradient)) return run.Finish(*x);
  while (run.Continue(gradient)) {
    if (!run.Hessian(*x, &hessian) || !NewtonDirection(gradient, hessian, &shift, cholesky.get(),
                                                       &run.summary(), &direction)) {
      run.End(Termination::kStalled, "the Hessian could not be made positive definite");
      break;
    }
    LineSearchResult step = SearchAlong(*x, gradient, direction, &run);
    if (!step.found && shift.Raise()) continue;
    if (!step.found) {
      run.End(Termination::kStalled, "no step along the Newton direction improves x");
      break;
    }
    shift.Adapt(step.step_length);
    *x = std::move(step.x);
    gradient = std::move(step.gradient);
    if (!run.Accept(*x, gradient, step.step_length)) break;
  }
  run.summary().symbolic_analyses = cholesky->symbolic_analyses();
  run.summary().factorizations = cholesky->factorizations();
  return run.Finish(*x);
}

}  // namespace cirque

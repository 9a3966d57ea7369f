#include "cirque/solver/newton_amg_strategy.h"

#include <utility>

#include "cirque/solver/inexact_newton.h"
#include "cirque/solver/regularization.h"

namespace cirque {

const OptionTable<NewtonAmgOptions>& NewtonAmgOptionTable() {
  using Options = NewtonAmgOptions;
  static const OptionTable<Options> kTable("newton_amg", [] {
    auto fields = LimitFields<Options>();
    fields.push_back({"multigrid",
                      &Options::multigrid,
                      0,
                      0,
                      {"boomeramg", "gamg"},
                      "the method; default: boomeramg where PETSc has hypre"});
    for (auto& field : InexactNewtonFields<Options>(
             "conjugate gradient iterations a system before factoring it")) {
      fields.push_back(std::move(field));
    }
    return fields;
  }());
  return kTable;
}

SolveSummary NewtonAmgStrategy::Minimize(const Energy& energy, const SolveControl& control,
                                         Eigen::VectorXd* x) const {
  SolveRun run("newton_amg", options_, control, energy);
  AmgSystemSolver own(options_);
  SystemSolver* solver = control.system_solver ? control.system_solver : &own;
  if (SparseMatrix smooth; !control.system_solver && energy.SmoothHessian(x->data(), &smooth)) {
    HessianShift(energy).Regularize(&smooth);
    own.ExpectSystemsNear(smooth, &run.summary());
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

}  // namespace cirque

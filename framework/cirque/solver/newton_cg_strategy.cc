#include "cirque/solver/newton_cg_strategy.h"

#include <utility>

#include "cirque/linear/reused_factor.h"
#include "cirque/solver/inexact_newton.h"

namespace cirque {
const OptionTable<NewtonCgOptions>& NewtonCgOptionTable() {
  static const OptionTable<NewtonCgOptions> kTable("newton_cg", [] {
    auto fields = LimitFields<NewtonCgOptions>();
    fields.push_back({"linear_solver", &NewtonCgOptions::linear_solver, 0, 0,
                      LinearSolvers().Names(), "sparse Cholesky; default: the first"});
    for (auto& field : InexactNewtonFields<NewtonCgOptions>(
             "conjugate gradient iterations a step before factoring anew")) {
      fields.push_back(std::move(field));
    }
    return fields;
  }());
  return kTable;
}

SolveSummary NewtonCgStrategy::Minimize(const Energy& energy, const SolveControl& control,
                                        Eigen::VectorXd* x) const {
  SolveRun run("newton_cg", options_, control, energy);
  ReusedFactor own(MakeCholesky(options_.linear_solver), options_.max_cg_iterations);
  SystemSolver* solver = control.system_solver ? control.system_solver : &own;
  IterateInexactNewton(options_.forcing, solver, &run, x);
  return run.Finish(*x);
}

}  // namespace cirque

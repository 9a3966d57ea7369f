#include "cirque/solver/auto_strategy.h"

#include <fmt/format.h>

#include "cirque/solver/newton_amg_strategy.h"
#include "cirque/solver/newton_cg_strategy.h"
#include "cirque/solver/newton_strategy.h"

namespace cirque {
namespace {

/// Just above the largest systems measured (results/multigrid.md): there a factor takes a third
/// more memory than multigrid, and the share grows; in time neither is far ahead.
constexpr int kMultigridUnknowns = 10000000;

/// The limits as the first part of another strategy's options.
template <class Options>
Options WithLimits(const SolverLimits& limits) {
  Options options;
  static_cast<SolverLimits&>(options) = limits;
  return options;
}

bool UsesMultigrid(int num_unknowns) {
  return BuiltWithMultigrid() && num_unknowns >= kMultigridUnknowns;
}

}  // namespace

const OptionTable<SolverLimits>& AutoOptionTable() {
  static const OptionTable<SolverLimits> kTable("auto", LimitFields<SolverLimits>());
  return kTable;
}

SolveSummary AutoStrategy::Minimize(const Energy& energy, const SolveControl& control,
                                    Eigen::VectorXd* x) const {
  SolveSummary summary;
  if (control.system_solver && UsesMultigrid(energy.NumParameters())) {
    const NewtonAmgStrategy newton_amg(WithLimits<NewtonAmgOptions>(limits_));
    summary = newton_amg.Minimize(energy, control, x);
    summary.strategy =
        fmt::format("auto: newton_amg, for there are {} unknowns or more", kMultigridUnknowns);
  } else {
    const NewtonCgStrategy newton_cg(WithLimits<NewtonCgOptions>(limits_));
    summary = newton_cg.Minimize(energy, control, x);
    summary.strategy = "auto: newton_cg, for " +
                       (!control.system_solver
                            ? "each start is new"
                            : fmt::format("there are fewer than {} unknowns", kMultigridUnknowns));
  }
  return summary;
}

std::unique_ptr<SystemSolver> AutoStrategy::MakeSystemSolver(int num_unknowns) const {
  if (!UsesMultigrid(num_unknowns)) return SolverStrategy::MakeSystemSolver(num_unknowns);
  return NewtonAmgStrategy(WithLimits<NewtonAmgOptions>(limits_)).MakeSystemSolver(num_unknowns);
}

}  // namespace cirque

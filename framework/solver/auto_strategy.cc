#include "cirque/solver/auto_strategy.h"

#include "cirque/solver/newton_cg_strategy.h"
#include "cirque/solver/newton_strategy.h"

namespace cirque {
namespace {

/// The limits as the first part of another strategy's options.
template <class Options>
Options WithLimits(const SolverLimits& limits) {
  Options options;
  static_cast<SolverLimits&>(options) = limits;
  return options;
}

}  // namespace

const OptionTable<SolverLimits>& AutoOptionTable() {
  static const OptionTable<SolverLimits> kTable("auto", LimitFields<SolverLimits>());
  return kTable;
}

SolveSummary AutoStrategy::Minimize(const Energy& energy, const SolveControl& control,
                                    Eigen::VectorXd* x) const {
  SolveSummary summary;
  if (control.factor) {
    const NewtonCgStrategy newton_cg(WithLimits<NewtonCgOptions>(limits_));
    summary = newton_cg.Minimize(energy, control, x);
    summary.strategy = "auto: newton_cg, for a factor near the Hessian is at hand";
  } else {
    summary = NewtonStrategy(WithLimits<NewtonOptions>(limits_)).Minimize(energy, control, x);
    summary.strategy = "auto: newton, for no factor is at hand";
  }
  return summary;
}

}  // namespace cirque

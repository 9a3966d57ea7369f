#include <string>

#include <fmt/format.h>

#include "cirque/solver/newton_strategies.h"

namespace cirque {
namespace {

/// Where a map's factors begin to need more than 16 GB. Multigrid takes less memory and at 13
/// million unknowns 1.4 times as long, which grows more slowly (results/multigrid.md).
constexpr int kMultigridUnknowns = 20000000;

/// A factorization then takes milliseconds; exact steps end sooner where there is no minimum, and
/// in better proofs of that.
constexpr int kSmall = 6000;

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
  static const OptionTable<SolverLimits> kTable("auto", LimitOptions<SolverLimits>());
  return kTable;
}

SolveSummary AutoStrategy::Minimize(const Energy& energy, const SolveControl& control,
                                    Eigen::VectorXd* x) const {
  SolveSummary summary;
  std::string reason = fmt::format("there are {} unknowns or more", kMultigridUnknowns);
  if (UsesMultigrid(energy.NumParameters())) {
    const NewtonAmgStrategy newton_amg(WithLimits<NewtonAmgOptions>(limits_));
    summary = newton_amg.Minimize(energy, control, x);
  } else if (!control.system_solver && energy.NumParameters() < kSmall) {
    summary = NewtonStrategy(WithLimits<NewtonOptions>(limits_)).Minimize(energy, control, x);
    reason = fmt::format("there are fewer than {} unknowns", kSmall);
  } else {
    const NewtonCgStrategy newton_cg(WithLimits<NewtonCgOptions>(limits_));
    summary = newton_cg.Minimize(energy, control, x);
    reason = BuiltWithMultigrid()
                 ? fmt::format("there are fewer than {} unknowns", kMultigridUnknowns)
                 : "multigrid was not built in";
  }
  summary.strategy = fmt::format("auto: {}, for {}", summary.strategy, reason);
  return summary;
}

std::unique_ptr<SystemSolver> AutoStrategy::MakeSystemSolver(int num_unknowns) const {
  if (!UsesMultigrid(num_unknowns)) return SolverStrategy::MakeSystemSolver(num_unknowns);
  return NewtonAmgStrategy(WithLimits<NewtonAmgOptions>(limits_)).MakeSystemSolver(num_unknowns);
}

std::unique_ptr<EnergyOnRanks> AutoStrategy::TakeToRanks(const EnergySource& source) const {
  if (!UsesMultigrid(source.NumParameters())) return nullptr;
  return NewtonAmgStrategy(WithLimits<NewtonAmgOptions>(limits_)).TakeToRanks(source);
}

}  // namespace cirque

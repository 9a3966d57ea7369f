#include "cirque/angles/registry.h"

#include <algorithm>
#include <utility>

#include "cirque/angles/augmented_lagrangian_angle_solver.h"
#include "cirque/angles/infeasibility.h"
#include "cirque/angles/interior_point_angle_solver.h"
#include "cirque/core/option.h"
#include "cirque/core/text.h"
#include "cirque/energy/dual_angle_energy.h"
#include "cirque/linear/multigrid.h"
#include "cirque/solver/solver_strategy.h"

namespace cirque {
namespace {

constexpr char kDual[] = "dual", kStrategy[] = "strategy";

/// Minimises the dual with any strategy. The callback gets the multipliers.
class DualAngleSolver final : public AngleSolver {
 public:
  explicit DualAngleSolver(std::shared_ptr<const SolverStrategy> strategy)
      : strategy_(std::move(strategy)) {}

  Status Fit(const AngleFitProblem& problem, const std::shared_ptr<const AngleObjective>& objective,
             const SolveControl& control, AngleFitResult* result) const override {
    const DualAngleEnergy energy(problem.constraints, problem.reference, problem.epsilon,
                                 objective);
    InfeasibilityWatch watch(problem.constraints, objective->Margin(problem.epsilon));
    const auto observe = [&](const IterationRecord& record, const Eigen::VectorXd& y) {
      if (control.callback && control.callback(record, y) == CallbackAction::kStop) {
        return CallbackAction::kStop;
      }
      return watch.Found(y) ? CallbackAction::kStop : CallbackAction::kContinue;
    };
    Eigen::VectorXd y =
        problem.start ? *problem.start : Eigen::VectorXd::Zero(energy.NumParameters()).eval();
    result->solve = strategy_->Minimize(energy, {observe, control.cancelled}, &y);
    if (result->solve.termination == Termination::kUnsupported) {
      return Status::InvalidInput("angle fit: " + result->solve.message);
    }
    Eigen::VectorXd alpha = energy.Angles(y.data());
    return FinishFit(problem, *objective, watch.certificate(), std::move(alpha), std::move(y),
                     result);
  }

 private:
  std::shared_ptr<const SolverStrategy> strategy_;
};

using Made = StatusOr<std::shared_ptr<const AngleSolver>>;

Made MakeDual(const OptionMap& options) {
  OptionMap rest = options;
  const auto named = rest.extract(kStrategy);
  const auto strategy =
      MakeSolverStrategy(named ? named.mapped() : SolverStrategies().Names().front(), rest);
  if (!strategy.ok()) return strategy.status();
  return std::shared_ptr<const AngleSolver>(std::make_shared<DualAngleSolver>(*strategy));
}

/// A factory whose solver type S is constructed from its options struct O, read through `table`.
template <class S, class O>
AngleSolverFactory SolverFactory(const OptionTable<O>& table) {
  return [table](const OptionMap& map) -> Made {
    O options;
    if (Status status = table.Set(map, &options); !status.ok()) return status;
    return std::shared_ptr<const AngleSolver>(std::make_shared<S>(options));
  };
}

}  // namespace

const Registry<AngleSolverFactory>& AngleSolvers() {
  static const Registry<AngleSolverFactory> kTable(
      "angle solver",
      {
          {kDual, MakeDual},
          {"interior_point", SolverFactory<InteriorPointAngleSolver>(InteriorPointOptionTable())},
          {"ceres_augmented_lagrangian",
           SolverFactory<AugmentedLagrangianAngleSolver>(AugmentedLagrangianOptionTable())},
      });
  return kTable;
}

std::vector<std::string> AngleSolverNames() {
  std::vector<std::string> names = KnownStrategyNames();
  for (const std::string& name : AngleSolvers().Names()) names.push_back(name);
  return names;
}

namespace {

/// An entry of AngleSolvers() by its text; a solver strategy is the dual's.
StatusOr<NameWithOptions> ParseAngleSolver(const std::string& text) {
  StatusOr<NameWithOptions> named = ParseNameWithOptions(text);
  if (!named.ok() || AngleSolvers().Find(named->name).ok()) return named;
  const std::vector<std::string> names = AngleSolverNames();
  if (std::find(names.begin(), names.end(), named->name) == names.end()) {
    return Status::InvalidInput(UnknownName("angle solver", named->name, names));
  }
  named->options[kStrategy] = std::exchange(named->name, kDual);
  return named;
}

}  // namespace

Made MakeAngleSolver(const std::string& text, const OptionMap& options) {
  StatusOr<NameWithOptions> named = ParseAngleSolver(text);
  if (!named.ok()) return named.status();
  named->options.insert(options.begin(), options.end());
  return (*AngleSolvers().Find(named->name))(named->options);
}

Status CheckAngleSolver(const std::string& text) {
  const bool is_lacking = !BuiltWithMultigrid() && IsDistributedAngleSolver(text);
  return is_lacking ? Status() : MakeAngleSolver(text).status();
}

bool IsDistributedAngleSolver(const std::string& text) {
  const StatusOr<NameWithOptions> named = ParseAngleSolver(text);
  if (!named.ok() || named->name != kDual) return false;
  const auto strategy = named->options.find(kStrategy);
  return strategy != named->options.end() && IsDistributedStrategy(strategy->second);
}

}  // namespace cirque

#include "cirque/angles/registry.h"

#include <algorithm>
#include <utility>

#include "cirque/angles/augmented_lagrangian_angle_solver.h"
#include "cirque/angles/infeasibility.h"
#include "cirque/angles/interior_point_angle_solver.h"
#include "cirque/core/option.h"
#include "cirque/core/text.h"
#include "cirque/energy/dual_angle_energy.h"
#include "cirque/solver/solver_strategy.h"

namespace cirque {
namespace {

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
  const auto named = rest.extract("strategy");
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
          {"dual", MakeDual},
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

Made MakeAngleSolver(const std::string& text, const OptionMap& options) {
  StatusOr<NameWithOptions> named = ParseNameWithOptions(text);
  if (!named.ok()) return named.status();
  named->options.insert(options.begin(), options.end());
  const std::string& name = named->name;
  if (const auto solver = AngleSolvers().Find(name); solver.ok()) {
    return (*solver)(named->options);
  }
  const std::vector<std::string> names = AngleSolverNames();
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    return Status::InvalidInput(UnknownName("angle solver", name, names));
  }
  named->options["strategy"] = name;
  return MakeDual(named->options);
}

Status CheckAngleSolver(const std::string& text) {
  const StatusOr<NameWithOptions> named = ParseNameWithOptions(text);
  const bool is_strategy = named.ok() && CheckSolverStrategy(named->name).ok();
  return is_strategy ? CheckSolverStrategy(text) : MakeAngleSolver(text).status();
}

}  // namespace cirque

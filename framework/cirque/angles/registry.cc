#include "cirque/angles/registry.h"

#include <algorithm>

#include "cirque/angles/augmented_lagrangian_angle_fit.h"
#include "cirque/angles/dual_angle_fit.h"
#include "cirque/angles/interior_point_angle_fit.h"
#include "cirque/core/text.h"
#include "cirque/solver/solver_strategy.h"

namespace cirque {
namespace {

using Method = StatusOr<std::shared_ptr<const AngleFitMethod>>;

Method MakeDual(const OptionMap& options) {
  OptionMap rest = options;
  const auto named = rest.extract("strategy");
  const auto strategy =
      MakeSolverStrategy(named ? named.mapped() : SolverStrategies().Names().front(), rest);
  if (!strategy.ok()) return strategy.status();
  return std::shared_ptr<const AngleFitMethod>(std::make_shared<DualAngleFit>(*strategy));
}

/// A factory whose method type M is constructed from its options struct O, read through `table`.
template <class M, class O>
AngleFitMethodFactory MethodFactory(const OptionTable<O>& table) {
  return [table](const OptionMap& map) -> Method {
    O options;
    if (Status status = table.Set(map, &options); !status.ok()) return status;
    return std::shared_ptr<const AngleFitMethod>(std::make_shared<M>(options));
  };
}

}  // namespace

const Registry<AngleFitMethodFactory>& AngleFitMethods() {
  static const Registry<AngleFitMethodFactory> kTable(
      "angle-fit method",
      {
          {"dual", MakeDual},
          {"interior_point", MethodFactory<InteriorPointAngleFit>(InteriorPointOptionTable())},
          {"ceres_augmented_lagrangian",
           MethodFactory<AugmentedLagrangianAngleFit>(AugmentedLagrangianOptionTable())},
      });
  return kTable;
}

std::vector<std::string> AngleStrategyNames() {
  std::vector<std::string> names = KnownStrategyNames();
  for (const std::string& name : AngleFitMethods().Names()) names.push_back(name);
  return names;
}

Method MakeAngleFitMethod(const std::string& name, const OptionMap& options) {
  if (const auto method = AngleFitMethods().Find(name); method.ok()) return (*method)(options);
  const std::vector<std::string> names = AngleStrategyNames();
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    return Status::InvalidInput(UnknownName("angle strategy", name, names));
  }
  OptionMap dual = options;
  dual["strategy"] = name;
  return MakeDual(dual);
}

}  // namespace cirque

#include "cirque/solver/newton_strategy.h"
#include "cirque/solver/solver_strategy.h"

namespace cirque {

const Registry<SolverStrategyFactory>& SolverStrategies() {
  static const Registry<SolverStrategyFactory> kTable(
      "solver strategy", {
                             {"newton", FactoryOf<NewtonStrategy>(NewtonOptionTable())},
                         });
  return kTable;
}

StatusOr<std::shared_ptr<const SolverStrategy>> MakeSolverStrategy(const std::string& name,
                                                                   const OptionMap& options) {
  const auto factory = SolverStrategies().Find(name);
  if (!factory.ok()) return factory.status();
  return (*factory)(options);
}

}  // namespace cirque

#include "cirque/solver/auto_strategy.h"
#include "cirque/solver/ceres_line_search_strategy.h"
#include "cirque/solver/ceres_trust_region_strategy.h"
#include "cirque/solver/newton_cg_strategy.h"
#include "cirque/solver/newton_strategy.h"
#include "cirque/solver/solver_strategy.h"

namespace cirque {

const Registry<SolverStrategyFactory>& SolverStrategies() {
  static const Registry<SolverStrategyFactory> kTable(
      "solver strategy", {
                             {"auto", FactoryOf<AutoStrategy>(AutoOptionTable())},
                             {"newton", FactoryOf<NewtonStrategy>(NewtonOptionTable())},
                             {"newton_cg", FactoryOf<NewtonCgStrategy>(NewtonCgOptionTable())},
                             {"ceres_trust_region",
                              FactoryOf<CeresTrustRegionStrategy>(CeresTrustRegionOptionTable())},
                             {"ceres_line_search", MakeCeresLineSearch},
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

#include "cirque/linear/registry.h"

#include "cirque/linear/lagged_factorization.h"
#include "cirque/solver/ceres_strategies.h"
#include "cirque/solver/newton_strategies.h"
#include "cirque/solver/solver_strategy.h"

namespace cirque {
namespace {

constexpr int kFactorIterations = 6;
constexpr char kMultigridStrategy[] = "newton_amg";

}  // namespace

const Registry<SolverStrategyFactory>& SolverStrategies() {
  static const Registry<SolverStrategyFactory> kTable(
      "solver strategy",
      {
          {"auto", FactoryOf<AutoStrategy>(AutoOptionTable())},
          {"newton", FactoryOf<NewtonStrategy>(NewtonOptionTable())},
          {"newton_cg", FactoryOf<NewtonCgStrategy>(NewtonCgOptionTable())},
          {"ceres_trust_region",
           FactoryOf<CeresTrustRegionStrategy>(CeresTrustRegionOptionTable())},
          {"ceres_line_search", MakeCeresLineSearch},
#ifdef CIRQUE_PETSC
          {kMultigridStrategy, FactoryOf<NewtonAmgStrategy>(NewtonAmgOptionTable())},
#endif
      });
  return kTable;
}

std::vector<std::string> KnownStrategyNames() {
  std::vector<std::string> names = SolverStrategies().Names();
  if (!BuiltWithMultigrid()) names.push_back(kMultigridStrategy);
  return names;
}

std::unique_ptr<SystemSolver> SolverStrategy::MakeSystemSolver(int) const {
  return std::make_unique<LaggedFactorization>(MakeCholesky(), kFactorIterations);
}

std::unique_ptr<EnergyOnRanks> SolverStrategy::TakeToRanks(const EnergySource&) const {
  return nullptr;
}

StatusOr<std::shared_ptr<const SolverStrategy>> MakeSolverStrategy(const std::string& name,
                                                                   const OptionMap& options) {
  if (name == kMultigridStrategy && !BuiltWithMultigrid()) return MultigridNotBuilt();
  const auto factory = SolverStrategies().Find(name);
  if (!factory.ok()) return factory.status();
  return (*factory)(options);
}

}  // namespace cirque

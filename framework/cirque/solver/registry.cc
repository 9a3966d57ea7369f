#include "cirque/linear/registry.h"

#include <algorithm>

#include "cirque/core/option.h"
#include "cirque/core/text.h"
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

StatusOr<std::shared_ptr<const SolverStrategy>> MakeSolverStrategy(const std::string& text,
                                                                   const OptionMap& options) {
  StatusOr<NameWithOptions> named = ParseNameWithOptions(text);
  if (!named.ok()) return named.status();
  if (named->name == kMultigridStrategy && !BuiltWithMultigrid()) return MultigridNotBuilt();
  const auto factory = SolverStrategies().Find(named->name);
  if (!factory.ok()) return factory.status();
  named->options.insert(options.begin(), options.end());
  return (*factory)(named->options);
}

Status CheckSolverStrategy(const std::string& text) {
  const StatusOr<NameWithOptions> named = ParseNameWithOptions(text);
  if (!named.ok()) return named.status();
  const std::vector<std::string> known = KnownStrategyNames();
  if (std::find(known.begin(), known.end(), named->name) == known.end()) {
    return Status::InvalidInput(UnknownName("solver strategy", named->name, known));
  }
  const bool is_built = SolverStrategies().Find(named->name).ok();
  return is_built ? MakeSolverStrategy(text).status() : Status();
}

bool IsDistributedStrategy(const std::string& strategy) {
  const StatusOr<NameWithOptions> named = ParseNameWithOptions(strategy);
  return named.ok() && named->name == kMultigridStrategy;
}

}  // namespace cirque

#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/option_table.h"
#include "cirque/core/registry.h"
#include "cirque/core/solve_summary.h"
#include "cirque/energy/energy.h"
#include "cirque/linear/system_solver.h"

namespace cirque {

/// Limits that every strategy understands; each strategy's own options struct begins with them.
struct SolverLimits {
  int max_iterations = 100;
  double gradient_tolerance = 1e-11;  ///< converged when max_i |dE/dx_i| <= gradient_tolerance
  double max_seconds = 1e9;
};

class EnergyOnRanks;

/// A way to minimise any Energy that offers the form it needs.
class SolverStrategy {
 public:
  virtual ~SolverStrategy() = default;

  /// Minimises `energy` from *x. The summary's termination says what *x then holds.
  virtual SolveSummary Minimize(const Energy& energy, const SolveControl& control,
                                Eigen::VectorXd* x) const = 0;

  /// What shall solve the systems of a start with this many unknowns, to be handed on to Minimize
  /// as control.system_solver. Unless the strategy has another: a LaggedFactorization.
  virtual std::unique_ptr<SystemSolver> MakeSystemSolver(int num_unknowns) const;

  /// That energy on all ranks, to be handed on to Minimize; null where this strategy does not work
  /// on ranks, or there is one alone. `source` must outlive it.
  virtual std::unique_ptr<EnergyOnRanks> TakeToRanks(const EnergySource& source) const;
};

/// Makes a strategy from its options; errors name the option, its value and its bound.
using SolverStrategyFactory =
    std::function<StatusOr<std::shared_ptr<const SolverStrategy>>(const OptionMap&)>;

/// The table of strategies, one line an entry in registry.cc.
const Registry<SolverStrategyFactory>& SolverStrategies();

/// Those names and the one that a build without PETSc lacks, last: what a config may say anywhere.
std::vector<std::string> KnownStrategyNames();

/// The strategy by its text, NAME or NAME:KEY=VALUE,..., of which `options` are those that it does
/// not give; errors name the option, its value and its bound.
StatusOr<std::shared_ptr<const SolverStrategy>> MakeSolverStrategy(const std::string& text,
                                                                   const OptionMap& options = {});

/// Whether a config may say that: a name of KnownStrategyNames() with options that it takes, as far as
/// this build knows it.
Status CheckSolverStrategy(const std::string& text);

/// Whether by that text, NAME or NAME:KEY=VALUE,..., processes share the work.
bool IsDistributedStrategy(const std::string& strategy);

/// The three options of SolverLimits, for the table of a struct that derives from it.
template <class T>
std::vector<Option<T>> LimitOptions() {
  constexpr double kMany = std::numeric_limits<int>::max();
  return {Option<T>("max_iterations", &T::max_iterations, "accepted steps").Between(0, kMany),
          Option<T>("gradient_tolerance", &T::gradient_tolerance, "largest |dE/dx_i| at the end")
              .Between(0, 1),
          Option<T>("max_seconds", &T::max_seconds, "wall time").Between(0, 1e9).Unit("s")};
}

/// A factory whose strategy type S is constructed from its options struct O, read through `table`.
template <class S, class O>
SolverStrategyFactory FactoryOf(const OptionTable<O>& table) {
  return [table](const OptionMap& map) -> StatusOr<std::shared_ptr<const SolverStrategy>> {
    O options;
    if (Status status = table.Set(map, &options); !status.ok()) return status;
    return std::shared_ptr<const SolverStrategy>(std::make_shared<S>(options));
  };
}

}  // namespace cirque

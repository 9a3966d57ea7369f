#include "experiments/run_experiment/config/energy_methods.h"

#include <string>

#include <fmt/format.h>

#include "cirque/core/text.h"
#include "cirque/energy/registry.h"
#include "cirque/solver/solver_strategy.h"

#include "experiments/common/solver_problem.h"
#include "experiments/run_experiment/config/planned_run.h"

namespace cirque {
namespace {

constexpr char kEnergy[] = "energy", kSolver[] = "energy_solver", kStart[] = "energy_start";

}  // namespace

Schema EnergyFields() {
  const EnergyTrial trial;
  return {
      {.path = std::string("methods.") + kEnergy,
       .help = "minimises this energy by itself on the surface, instead of making a map: flat "
               "vertices, on a closed surface all with the same share of its curvature",
       .matrix = true,
       .choices = Energies().Names()},
      {.path = std::string("methods.") + kSolver,
       .help = "the strategy that does, NAME or NAME:KEY=VALUE,... such as "
               "ceres_line_search:max_seconds=3; names " +
               Join(KnownStrategyNames()),
       .default_text = trial.solver,
       .matrix = true,
       .check = CheckSolverStrategy,
       .beside = {kEnergy}},
      {.path = std::string("methods.") + kStart,
       .help = "where it begins: own, at zero, or at coherent angles where zero is outside the "
               "energy's domain; solution, at newton's minimiser; near, up to 0.1 from that in "
               "every parameter",
       .default_text = trial.start,
       .matrix = true,
       .choices = EnergyStarts().Names(),
       .beside = {kEnergy}},
  };
}

void CheckEnergyEntry(const YAML::Node& entry, Diagnostics* problems) {
  if (!entry[kEnergy]) return;
  for (const auto& pair : entry) {
    const std::string key = pair.first.Scalar();
    if (key == "name" || key == "epsilon" || key == kEnergy || key == kSolver || key == kStart) {
      continue;
    }
    problems->Add(PlaceOf(pair.first),
                  fmt::format("'{}' has no meaning beside 'energy', which makes no map; it takes "
                              "{}, {} and epsilon",
                              key, kSolver, kStart));
  }
}

}  // namespace cirque

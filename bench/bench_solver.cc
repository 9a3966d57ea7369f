// Every strategy on the energies that the pipeline minimises, on a generated terrain: the circle
// pattern from zero radii, the dual angle fits from zero multipliers.
#include "cirque/solver/solver_strategy.h"

#include "bench/registration.h"
#include "bench/terrain.h"

namespace cirque {
namespace {

// First-order methods take thousands of iterations: what is timed is 100 of them.
constexpr char kMaxIterations[] = "100";

void TimeStrategy(benchmark::State& state, const std::string& name, const Energy& energy) {
  const auto strategy = *MakeSolverStrategy(name, {{"max_iterations", kMaxIterations}});
  SolveSummary summary;
  for (auto _ : state) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(energy.NumParameters());
    summary = strategy->Minimize(energy, {}, &x);
  }
  state.counters["iterations"] = summary.num_iterations();
  state.counters["factorizations"] = summary.factorizations;
  state.counters["cg_iterations"] = summary.cg_iterations;
  state.counters["gradient"] = summary.final_gradient_max;
}

/// Whether the energy has the form that the strategy needs.
bool Takes(const std::string& name, const std::string& energy) {
  const auto small = (*Energies().Find(energy))(Terrain(100));
  Eigen::VectorXd x = Eigen::VectorXd::Zero(small->NumParameters());
  const auto strategy = *MakeSolverStrategy(name, {{"max_iterations", "1"}});
  return strategy->Minimize(*small, {}, &x).termination != Termination::kUnsupported;
}

[[maybe_unused]] const bool kRegistered = [] {
  for (const std::string energy : {"circle_pattern", "quadratic_dual", "barrier_dual"}) {
    for (const std::string& name : SolverStrategies().Names()) {
      if (!Takes(name, energy)) continue;
      RegisterBySize(energy + "/" + name, {kSmall, kLarge},
                     [=](benchmark::State& state, int triangles) {
                       const EnergyInput& input = Terrain(triangles);
                       TimeStrategy(state, name, *(*Energies().Find(energy))(input));
                       CountFaces(state, triangles);
                     });
    }
  }
  return true;
}();

}  // namespace
}  // namespace cirque

// Every strategy on the circle-pattern energy of a generated terrain, from zero radii.
#include <benchmark/benchmark.h>
#include <glog/logging.h>

#include "cirque/solver/solver_strategy.h"

#include "bench/terrain.h"

namespace cirque {
namespace {

constexpr int kTriangles[] = {2000, 20000};
// First-order methods take thousands of iterations: what is timed is 100 of them.
constexpr char kMaxIterations[] = "100";

void TimeStrategy(benchmark::State& state, const std::string& name) {
  const EnergyInput& input = Terrain(static_cast<int>(state.range(0)));
  const std::unique_ptr<Energy> energy = (*Energies().Find("circle_pattern"))(input);
  const auto strategy = *MakeSolverStrategy(name, {{"max_iterations", kMaxIterations}});
  SolveSummary summary;
  for (auto _ : state) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(energy->NumParameters());
    summary = strategy->Minimize(*energy, {}, &x);
  }
  state.counters["iterations"] = summary.num_iterations();
  state.counters["factorizations"] = summary.factorizations;
  state.counters["gradient"] = summary.final_gradient_max;
}

[[maybe_unused]] const bool kRegistered = [] {
  FLAGS_minloglevel = google::GLOG_ERROR;
  for (const std::string& name : SolverStrategies().Names()) {
    auto* timed = benchmark::RegisterBenchmark(
        name.c_str(), [name](benchmark::State& state) { TimeStrategy(state, name); });
    for (const int triangles : kTriangles) timed->Arg(triangles);
    timed->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
}  // namespace cirque

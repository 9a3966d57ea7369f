// Every angle fit: each method on each objective that it takes, on a generated terrain.
#include "cirque/angles/angle_fit.h"
#include "cirque/angles/registry.h"

#include "bench/registration.h"
#include "bench/terrain.h"

namespace cirque {
namespace {

// A second each at 2000 triangles; the others are measured at 20000 too.
constexpr char kSlowMethod[] = "ceres_augmented_lagrangian";

Status Fit(const std::string& objective, const std::string& method, int triangles,
           AngleFitResult* fit) {
  const EnergyInput& input = Terrain(triangles);
  return FitAngles(
      {AngleConstraints(input.triangulation, input.targets), input.reference.value, input.epsilon},
      *AngleObjectives().Find(objective), **MakeAngleSolver(method), {}, fit);
}

void TimeFit(benchmark::State& state, const std::string& objective, const std::string& method,
             int triangles) {
  AngleFitResult fit;
  Status status;
  for (auto _ : state) status = Fit(objective, method, triangles, &fit);
  // An objective without inequalities may fit angles that are no circle pattern's: timed all the
  // same.
  state.counters["coherent"] = status.ok();
  state.counters["iterations"] = fit.solve.num_iterations();
  state.counters["factorizations"] = fit.solve.factorizations;
  CountFaces(state, triangles);
}

bool Takes(const std::string& method, const std::string& objective) {
  AngleFitResult fit;
  return Fit(objective, method, 100, &fit).code() != StatusCode::kInvalidInput;
}

[[maybe_unused]] const bool kRegistered = [] {
  for (const std::string& objective : AngleObjectives().Names()) {
    for (const std::string& method : AngleSolvers().Names()) {
      if (!Takes(method, objective)) continue;
      const auto time = [=](benchmark::State& state, int triangles) {
        TimeFit(state, objective, method, triangles);
      };
      if (method == kSlowMethod) {
        RegisterBySize(objective + "/" + method, {kSmall / 10}, time);
      } else {
        RegisterBySize(objective + "/" + method, {kSmall, kLarge}, time);
      }
    }
  }
  return true;
}();

}  // namespace
}  // namespace cirque

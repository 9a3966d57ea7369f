// From a surface to its map with all defaults, for the surface of every generator; and each angle
// objective, strategy of the log radii and refinement of the map on one of them.
#include "cirque/energy/angle_objective.h"
#include "cirque/generators/generators.h"
#include "cirque/pipeline/certificate.h"
#include "cirque/pipeline/finish_layout.h"
#include "cirque/pipeline/parameterize.h"
#include "cirque/solver/solver_strategy.h"

#include "bench/registration.h"
#include "bench/surfaces.h"

namespace cirque {
namespace {

void TimePipeline(benchmark::State& state, const std::string& generator,
                  const ParameterizeOptions& options, int triangles) {
  const Surface& surface = BenchSurface(generator, triangles);
  Parameterization map;
  Status status;
  for (auto _ : state) {
    map = {};
    status = Parameterize(surface, {options}, {}, &map);
  }
  const std::map<std::string, double> numbers = NumbersOf(map.certificate);
  for (const char* name : {"angle_iterations", "angle_factorizations", "radii_iterations",
                           "radii_factorizations", "cones"}) {
    const auto value = numbers.find(name);
    if (value != numbers.end()) state.counters[name] = value->second;
  }
  state.counters["mapped"] = status.ok();
  CountFaces(state, surface.triangulation.num_faces());
}

void Register(const std::string& name, const std::string& generator,
              const ParameterizeOptions& options, std::initializer_list<int> sizes) {
  RegisterBySize(name, sizes, [=](benchmark::State& state, int triangles) {
    TimePipeline(state, generator, options, triangles);
  });
}

[[maybe_unused]] const bool kRegistered = [] {
  for (const std::string& generator : MeshGenerators().Names()) {
    Register(generator, generator, {}, {kSmall, kLarge});
  }
  for (const std::string& objective : AngleObjectives().Names()) {
    ParameterizeOptions options;
    options.angle_objective = objective;
    Register("angle_objective:" + objective, "bumpy_terrain", options, {kLarge});
  }
  for (const std::string& strategy : SolverStrategies().Names()) {
    ParameterizeOptions options;
    options.radii_solver = strategy;
    Register("strategy:" + strategy, "bumpy_terrain", options, {kSmall});
  }
  for (const std::string& refinement : RefineMapNames()) {
    ParameterizeOptions options;
    options.refine_map = refinement;
    Register("refine_map:" + refinement, "bumpy_terrain", options, {kLarge});
  }
  return true;
}();

}  // namespace
}  // namespace cirque

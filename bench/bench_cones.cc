// Every cone heuristic with 8 cones, on a closed surface.
#include "cirque/cones/cone_problem.h"
#include "cirque/cones/registry.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"

#include "bench/registration.h"
#include "bench/surfaces.h"

namespace cirque {
namespace {

void TimeHeuristic(benchmark::State& state, const std::string& name, int triangles) {
  const Surface& surface = BenchSurface("blob", triangles);
  const IntrinsicTriangulation delaunay =
      MakeIntrinsicDelaunay(surface.triangulation, MeasureEdgeLengths(surface));
  const auto heuristic = MakeConeHeuristic(name, {{"cones", "8"}});
  StatusOr<std::vector<Cone>> cones = std::vector<Cone>();
  for (auto _ : state) {
    // The problem keeps the factor of its Laplacian, which is part of the cost.
    cones = (*heuristic)->Choose(ConeProblem(delaunay.triangulation, delaunay.lengths));
  }
  if (!cones.ok()) return state.SkipWithError(cones.status().message().c_str());
  state.counters["cones"] = static_cast<double>(cones->size());
  CountFaces(state, triangles);
}

[[maybe_unused]] const bool kRegistered = [] {
  for (const std::string& name : ConeHeuristics().Names()) {
    if (!MakeConeHeuristic(name, {{"cones", "8"}}).ok()) continue;  // it chooses no number of cones
    RegisterBySize(name, {kSmall, kLarge}, [name](benchmark::State& state, int triangles) {
      TimeHeuristic(state, name, triangles);
    });
  }
  return true;
}();

}  // namespace
}  // namespace cirque

// The stages without a solve: intrinsic flips and reading their map back, cuts, layouts, measures.
#include <map>
#include <memory>

#include <glog/logging.h>

#include "cirque/cuts/cut_graph.h"
#include "cirque/intrinsic/input_chart.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/layout/linear_layout.h"
#include "cirque/layout/planar_layout.h"
#include "cirque/metrics/measure_map.h"
#include "cirque/pipeline/parameterize.h"

#include "bench/registration.h"
#include "bench/surfaces.h"

namespace cirque {
namespace {

void TimeFlips(benchmark::State& state, int triangles) {
  const Surface& surface = StretchedTerrain(triangles);
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  IntrinsicTriangulation flipped;
  for (auto _ : state) flipped = MakeIntrinsicDelaunay(surface.triangulation, lengths);
  state.counters["flips"] = static_cast<double>(flipped.flips.size());
}

void TimeReadOnInput(benchmark::State& state, int triangles) {
  const Surface& surface = StretchedTerrain(triangles);
  const auto flipped = MakeIntrinsicDelaunay(surface.triangulation, MeasureEdgeLengths(surface));
  const CornerAngles angles = MeasureCornerAngles(flipped.triangulation, flipped.lengths);
  for (auto _ : state) {
    benchmark::DoNotOptimize(ReadOnInput(surface.triangulation, flipped, angles, flipped.lengths));
  }
}

void TimeCut(benchmark::State& state, int triangles) {
  const Surface& surface = BenchSurface("double_torus", triangles);
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  std::vector<Index> cones;
  for (Index v = 0; v < 8; ++v) cones.push_back(v * (surface.triangulation.num_vertices / 8));
  StatusOr<Cut> cut = Cut();
  for (auto _ : state) cut = CutGraph(surface.triangulation, lengths.value, cones);
  if (!cut.ok()) state.SkipWithError(cut.status().message().c_str());
}

/// The terrain's flat metric, solved once.
const Parameterization& FlatTerrain(int triangles) {
  static std::map<int, std::unique_ptr<const Parameterization>> cache;
  auto& map = cache[triangles];
  if (!map) {
    auto made = std::make_unique<Parameterization>();
    const Status status =
        Parameterize(BenchSurface("bumpy_terrain", triangles), {}, {}, made.get());
    CHECK(status.ok()) << status.message();
    map = std::move(made);
  }
  return *map;
}

void TimeDirections(benchmark::State& state, int triangles) {
  const Triangulation& t = BenchSurface("bumpy_terrain", triangles).triangulation;
  const Parameterization& map = FlatTerrain(triangles);
  const InputChart& flat = map.flat.on_input;
  PlanarLayout layout;
  for (auto _ : state) layout = LayOutPatches(t, flat.angles, flat.lengths, map.cut);
  state.counters["closure"] = layout.closure;
}

void TimeLeastSquares(benchmark::State& state, int triangles) {
  const Triangulation& t = BenchSurface("bumpy_terrain", triangles).triangulation;
  const Parameterization& map = FlatTerrain(triangles);
  const InputChart& flat = map.flat.on_input;
  StatusOr<PlanarLayout> layout = PlanarLayout();
  for (auto _ : state) layout = LayOutByLeastSquares(t, flat.angles, flat.lengths, map.cut);
  if (!layout.ok()) return state.SkipWithError(layout.status().message().c_str());
  state.counters["closure"] = layout->closure;
}

void TimeMeasures(benchmark::State& state, int triangles) {
  const Surface& surface = BenchSurface("bumpy_terrain", triangles);
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const Parameterization& map = FlatTerrain(triangles);
  for (auto _ : state) {
    benchmark::DoNotOptimize(MeasureMap(surface.triangulation, lengths, map.uv));
  }
}

struct Stage {
  const char* name;
  void (*time)(benchmark::State&, int triangles);
};

constexpr Stage kStages[] = {{"flips", TimeFlips},
                             {"read_on_input", TimeReadOnInput},
                             {"cut", TimeCut},
                             {"layout/directions", TimeDirections},
                             {"layout/least_squares", TimeLeastSquares},
                             {"measures", TimeMeasures}};

[[maybe_unused]] const bool kRegistered = [] {
  for (const Stage& stage : kStages) {
    RegisterBySize(stage.name, {kSmall, kLarge},
                   [time = stage.time](benchmark::State& state, int triangles) {
                     time(state, triangles);
                     CountFaces(state, triangles);
                   });
  }
  return true;
}();

}  // namespace
}  // namespace cirque

// Many components in one run beside one mesh of as many triangles: mapped, then laid side by side.
#include <vector>

#include "cirque/domains/atlas.h"
#include "cirque/domains/map_components.h"

#include "bench/registration.h"
#include "bench/surfaces.h"

namespace cirque {
namespace {

void TimeComponents(benchmark::State& state, int components, int triangles) {
  const Surface& surface = BenchSurface("bumpy_terrain", triangles / components);
  std::vector<ComponentJob> jobs(components, {surface, {}, {}});
  ArrangedAtlas atlas;
  int mapped_components = 0;
  for (auto _ : state) {
    std::vector<MappedComponent> mapped = MapComponents(jobs, {});
    std::vector<PlanarPiece> pieces;
    for (MappedComponent& component : mapped) {
      if (component.status.ok()) pieces.push_back({surface, component.map.cut, &component.map.uv});
    }
    mapped_components = static_cast<int>(pieces.size());
    atlas = ArrangeAtlas({}, pieces);
  }
  state.counters["mapped"] = mapped_components;
  state.counters["area_used"] = atlas.area_used;
  CountFaces(state, components * surface.triangulation.num_faces());
}

[[maybe_unused]] const bool kRegistered = [] {
  for (const int components : {1, 100, 1000}) {
    RegisterBySize("components:" + std::to_string(components), {1000000},
                   [=](benchmark::State& state, int triangles) {
                     TimeComponents(state, components, triangles);
                   });
  }
  return true;
}();

}  // namespace
}  // namespace cirque

#include "cirque/layout/refine_map.h"

#include <utility>

#include "cirque/layout/gauss_newton.h"

namespace cirque {

const OptionTable<RefineMapOptions>& RefineMapOptionTable() {
  using O = RefineMapOptions;
  static const OptionTable<O> kTable(
      "refine_map",
      {Option<O>("steps", &O::steps, "the most steps").Between(1, 1e6),
       Option<O>("decrease", &O::decrease, "share of the objective to go on for").Between(0, 1)});
  return kTable;
}

StatusOr<MapRefinement> RefineMap(const SeamedSurface& of, const MapObjective& objective,
                                  const RefineMapOptions& options,
                                  const std::atomic<bool>* cancelled, CornerUv* uv) {
  OpenedMap map(of, *uv, 0);
  MapRefinement result;
  result.before = map.Mean(objective);
  result.steps = LowerObjective(map.Whole(), objective, {options.steps, options.decrease},
                                cancelled, &map.z());
  if (cancelled && *cancelled)
    return Status(StatusCode::kCancelled, "refinement of the map: interrupted");
  result.after = map.Mean(objective);
  if (result.steps > 0) map.WriteTo(uv);
  return result;
}

}  // namespace cirque

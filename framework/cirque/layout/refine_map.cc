#include "cirque/layout/refine_map.h"

#include <utility>
#include <vector>

#include "cirque/layout/gauss_newton.h"
#include "cirque/layout/stretch_sum.h"

namespace cirque {
namespace {

/// Up to which shares of a boundary edge's length the barrier reaches, one after the other.
constexpr double kReaches[] = {0.25, 0.05, 0.01};

/// LowerStretch with a barrier that reaches less and less far; a contact weighs as much as a face.
int LowerFenced(MapPart* whole, const StretchEnergy& energy, double unit,
                const RefineStretchOptions& options, const std::atomic<bool>* cancelled,
                Eigen::VectorXcd* z) {
  whole->fence->weight = 1 / static_cast<double>(whole->faces.size());
  int steps = 0;
  for (const double share : kReaches) {
    if (share < options.least_reach) break;
    whole->fence->SetReach(*z, share);
    const StepLimits limits = {options.steps - steps, options.decrease};
    steps += LowerStretch(*whole, energy, unit, limits, cancelled, z);
  }
  return steps;
}

}  // namespace

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
  result.at_rest = result.steps < options.steps;
  if (result.steps > 0) map.WriteTo(uv);
  return result;
}

const OptionTable<RefineStretchOptions>& RefineStretchOptionTable(bool blends) {
  using O = RefineStretchOptions;
  static const std::vector<Option<O>> kOfAll = {
      Option<O>("steps", &O::steps, "the most steps").Between(1, 1e6),
      Option<O>("decrease", &O::decrease, "share of the energy to go on for").Between(0, 1)};
  static const OptionTable<O> kPlain("refine_map", kOfAll);
  static const OptionTable<O> kBlending(
      "refine_map",
      Joined<O>(kOfAll, {Option<O>("weight", &O::weight, "of area, 0: angles alone; 1: area alone")
                             .Between(0, 1)}));
  return blends ? kBlending : kPlain;
}

StatusOr<MapRefinement> RefineStretch(const SeamedSurface& of, StretchEnergy energy,
                                      const RefineStretchOptions& options,
                                      const std::atomic<bool>* cancelled, CornerUv* uv) {
  energy.weight = options.weight;
  OpenedMap map(of, *uv, 0);
  const double unit = BestUnit(map.faces(), energy, map.z());
  MapRefinement result;
  result.before = StretchOf(map.faces(), energy, unit, map.z());
  MapPart whole = map.Whole();
  const StepLimits limits = {options.steps, options.decrease};
  result.steps = whole.fence ? LowerFenced(&whole, energy, unit, options, cancelled, &map.z())
                             : LowerStretch(whole, energy, unit, limits, cancelled, &map.z());
  if (cancelled && *cancelled)
    return Status(StatusCode::kCancelled, "refinement of the map: interrupted");
  const double now = BestUnit(map.faces(), energy, map.z());
  result.after = StretchOf(map.faces(), energy, now, map.z());
  result.at_rest = result.steps < options.steps;
  if (result.steps > 0) map.WriteTo(uv);
  return result;
}

}  // namespace cirque

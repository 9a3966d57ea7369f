#include "cirque/pipeline/refine_layout.h"

#include <utility>

#include "cirque/core/name_with_options.h"
#include "cirque/intrinsic/corner_angles.h"
#include "cirque/layout/refine_map.h"
#include "cirque/layout/seams.h"
#include "cirque/metrics/injectivity.h"

namespace cirque {
namespace {

constexpr char kNoRefinement[] = "none";

struct Refinement {
  MapObjective objective;
  RefineMapOptions options;
};

StatusOr<Refinement> Parse(const std::string& refine_map) {
  const StatusOr<NameWithOptions> named = ParseNameWithOptions(refine_map);
  if (!named.ok()) return named.status();
  const StatusOr<MapObjective> objective = MapObjectives().Find(named->name);
  if (!objective.ok()) return objective.status();
  Refinement refinement{*objective, {}};
  if (Status s = RefineMapOptionTable().Set(named->options, &refinement.options); !s.ok()) return s;
  return refinement;
}

}  // namespace

Status CheckRefineMap(const std::string& refine_map) {
  return refine_map == kNoRefinement ? Status() : Parse(refine_map).status();
}

Status RefineLayout(const Triangulation& t, const EdgeLengths& lengths, const InputChart& flat,
                    const Cut& cut, const std::vector<Index>& cones, const std::string& refine_map,
                    const std::atomic<bool>* cancelled, PlanarLayout* layout,
                    Certificate* certificate) {
  if (refine_map == kNoRefinement) return Status();
  const StatusOr<Refinement> refinement = Parse(refine_map);
  if (!refinement.ok()) return refinement.status();
  const SeamReport report = MeasureSeams(t, cut, cones, flat.angles, layout->uv);
  CornerUv refined = layout->uv;
  const StatusOr<MapRefinement> done =
      RefineMap(t, MeasureCornerAngles(t, lengths), lengths, cut, report.seams,
                refinement->objective, refinement->options, cancelled, &refined);
  if (!done.ok()) return done.status();
  // Scaling to the area that it had rounds once more.
  const bool kept = done->steps > 0 && FlippedFaces(t, refined).empty();
  if (kept) layout->uv = std::move(refined);
  auto& values = certificate->values;
  values["map_refinement_steps"] = kept ? done->steps : 0;
  values["map_refinement_before"] = done->before;
  values["map_refinement_after"] = kept ? done->after : done->before;
  return Status();
}

}  // namespace cirque

#include "cirque/pipeline/refine_layout.h"

#include <utility>

#include "cirque/core/name_with_options.h"
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

Status RefineLayout(const LaidOutSurface& of, const std::string& refine_map, PlanarLayout* layout,
                    std::optional<MapRefinementSummary>* summary) {
  if (refine_map == kNoRefinement) return Status();
  const StatusOr<Refinement> refinement = Parse(refine_map);
  if (!refinement.ok()) return refinement.status();
  const Triangulation& t = of.surface.triangulation;
  const SeamReport report = MeasureSeams(t, of.cut, of.cones, of.flat.angles, layout->uv);
  CornerUv refined = layout->uv;
  const StatusOr<MapRefinement> done =
      RefineMap(t, of.surface.angles, of.surface.lengths, of.cut, report.seams,
                refinement->objective, refinement->options, of.cancelled, &refined);
  if (!done.ok()) return done.status();
  // Scaling to the area that it had rounds once more.
  const bool kept = done->steps > 0 && FlippedFaces(t, refined).empty();
  if (kept) layout->uv = std::move(refined);
  *summary = {kept ? done->steps : 0, done->before, kept ? done->after : done->before};
  return Status();
}

}  // namespace cirque

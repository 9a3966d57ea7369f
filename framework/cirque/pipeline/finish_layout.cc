#include "cirque/pipeline/finish_layout.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cirque/core/option.h"
#include "cirque/layout/packing.h"
#include "cirque/layout/refine_map.h"
#include "cirque/layout/seams.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/metrics/measure_map.h"

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

constexpr double kMultiple = 1e-12;  ///< [rad]: of targets, which are read with some digits
constexpr double kRotation = 1e-6;   ///< [rad]: of seams, which carry the errors of a solve

std::string ToString(BoundaryContact contact) {
  switch (contact) {
    case BoundaryContact::kApart:
      return "injective";
    case BoundaryContact::kTouch:
      return "boundary_touches";
    case BoundaryContact::kCrossing:
      return "boundary_overlaps";
  }
  return "unknown";
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
      RefineMap({of.surface, of.cut, report.seams}, refinement->objective, refinement->options,
                of.cancelled, &refined);
  if (!done.ok()) return done.status();
  // Scaling to the area that it had rounds once more.
  const bool kept = done->steps > 0 && FlippedFaces(t, refined).empty();
  if (kept) layout->uv = std::move(refined);
  *summary = {kept ? done->steps : 0, done->before, kept ? done->after : done->before};
  return Status();
}

int CommonRotationOrder(const ConeTargets& targets, const std::vector<Index>& cones) {
  for (const int order : {4, 6}) {
    const bool fits = std::all_of(cones.begin(), cones.end(), [&](Index v) {
      const double step = 2 * kPi / order;
      return targets.IsFixed(v) && std::abs(std::remainder(targets.lower[v], step)) <= kMultiple;
    });
    if (fits) return order;
  }
  return 0;
}

bool SnapRotations(const Triangulation& t, const Cut& cut, const std::vector<Index>& cones,
                   const CornerAngles& flat_angles, int order, CornerUv* uv) {
  const SeamReport seams = MeasureSeams(t, cut, cones, flat_angles, *uv);
  const auto multiple = IntegerRotations(t, seams, order, kRotation);
  if (!multiple.ok()) return false;
  if (seams.seams.empty()) return true;
  CornerUv snapped = *uv;
  SnapSeams(t, cut, seams, *multiple, order, &snapped);
  if (!FlippedFaces(t, snapped).empty()) return false;
  *uv = std::move(snapped);
  return true;
}

int ArrangePatches(const LaidOutSurface& of, const ConeTargets& targets, PlanarLayout* layout) {
  if (layout->patches.count > 1) {
    layout->uv = PackPatches(layout->uv, layout->patches, {}).uv;
    return 0;
  }
  const int order = CommonRotationOrder(targets, of.cones);
  const bool exact = order > 0 && SnapRotations(of.surface.triangulation, of.cut, of.cones,
                                                of.flat.angles, order, &layout->uv);
  return exact ? order : 0;
}

void MeasureDistortion(const Triangulation& t, const EdgeLengths& lengths, const Cut& cut,
                       const CornerUv& uv, Certificate* certificate) {
  certificate->overlap = ToString(FindBoundaryContact(CutOpen(t, cut), uv));
  certificate->distortion = DistortionOf(t, lengths, uv);
}

DistortionSummary DistortionOf(const Triangulation& t, const EdgeLengths& lengths,
                               const CornerUv& uv) {
  const auto figures =
      MeasureFigures(t, lengths, uv,
                     {"quasi_conformal_mean", "quasi_conformal_max", "log_area_ratio_l2",
                      "log_area_ratio_min", "log_area_ratio_max"});
  return {figures->at("quasi_conformal_mean"), figures->at("quasi_conformal_max"),
          figures->at("log_area_ratio_l2"), figures->at("log_area_ratio_min"),
          figures->at("log_area_ratio_max")};
}

}  // namespace cirque

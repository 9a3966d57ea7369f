#include "cirque/pipeline/finish_layout.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "cirque/core/option.h"
#include "cirque/core/text.h"
#include "cirque/layout/packing.h"
#include "cirque/layout/refine_map.h"
#include "cirque/layout/refine_patches.h"
#include "cirque/layout/seams.h"
#include "cirque/layout/stretch_energy.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/metrics/measure_map.h"

namespace cirque {
namespace {

constexpr char kNoRefinement[] = "none";
constexpr char kByPatches[] = "auto";
constexpr double kStraight = 1e-12;  ///< [rad] by which a straight boundary's targets may miss pi

struct Refinement {
  std::optional<MapObjective> objective;
  std::optional<StretchEnergy> stretch;  ///< neither: by patches
  RefineMapOptions whole;
  RefineStretchOptions of_stretch;
  RefinePatchesOptions patches;
};

StatusOr<Refinement> Parse(const std::string& refine_map) {
  const StatusOr<NameWithOptions> named = ParseNameWithOptions(refine_map);
  if (!named.ok()) return named.status();
  if (named->name == kNoRefinement) {
    return Status::InvalidInput(std::string(kNoRefinement) + " takes no options");
  }
  Refinement refinement;
  Status status;
  if (named->name == kByPatches) {
    status = RefinePatchesOptionTable().Set(named->options, &refinement.patches);
  } else if (const auto stretch = StretchEnergies().Find(named->name); stretch.ok()) {
    refinement.stretch = *stretch;
    status = RefineStretchOptionTable(stretch->blends).Set(named->options, &refinement.of_stretch);
  } else {
    const StatusOr<MapObjective> objective = MapObjectives().Find(named->name);
    if (!objective.ok()) {
      return Status::InvalidInput(UnknownName("map objective", named->name, RefineMapNames()));
    }
    refinement.objective = *objective;
    status = RefineMapOptionTable().Set(named->options, &refinement.whole);
  }
  if (!status.ok()) return status;
  return refinement;
}

/// Whether the angle sum of a vertex on the boundary was left to the fit.
bool IsFree(const ConeTargets& targets, const ConeTargets& free, Index v) {
  return targets.lower[v] <= free.lower[v] && targets.upper[v] >= free.upper[v];
}

/// What a shape prescribed by angle sums on the boundary is held by: the vertices that have them
/// and their neighbours along it.
std::vector<bool> HeldBoundary(const Triangulation& t, const ConeTargets& targets) {
  const ConeTargets free = FreeBoundaryTargets(t);
  std::vector<bool> held(t.num_vertices, false);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (t.twin[h] != kNone) continue;
    const Index a = t.Tail(h), b = t.Tip(h);
    if (!IsFree(targets, free, a) || !IsFree(targets, free, b)) held[a] = held[b] = true;
  }
  return held;
}

/// Lets the straight vertices of a boundary loop between two that are held slide along the line
/// between those.
void SlideAlongSides(const Triangulation& t, const ConeTargets& targets, const CornerUv& uv,
                     std::vector<Index> loop, KeptVertices* kept) {
  const auto corner_of = [&](Index h) { return t.Tail(h); };
  const auto straight = [&](Index h) {
    const Index v = corner_of(h);
    return targets.IsFixed(v) && std::abs(targets.lower[v] - kPi) <= kStraight;
  };
  const auto first = std::find_if_not(loop.begin(), loop.end(), straight);
  if (first == loop.end()) return;
  std::rotate(loop.begin(), first, loop.end());
  loop.push_back(loop.front());
  for (std::size_t begin = 0, end = 1; end < loop.size(); ++end) {
    if (straight(loop[end])) continue;
    const auto place = [&](Index h) {
      const Eigen::Vector2d& p = uv.value[Triangulation::Next(h)];  // its tail
      return std::complex<double>(p.x(), p.y());
    };
    const std::complex<double> side = place(loop[end]) - place(loop[begin]);
    for (std::size_t k = begin + 1; k < end && std::abs(side) > 0; ++k) {
      const Index v = corner_of(loop[k]);
      kept->sliding.slides[v] = true;
      kept->sliding.direction[v] = side / std::abs(side);
      kept->held[v] = false;
    }
    begin = end;
  }
}

KeptVertices KeepPrescribedBoundary(const Triangulation& t, const ConeTargets& targets,
                                    const SeamReport& seams, const CornerUv& uv) {
  KeptVertices kept{HeldBoundary(t, targets)};
  if (!seams.seams.empty()) return kept;
  kept.sliding.slides.assign(t.num_vertices, false);
  kept.sliding.direction.assign(t.num_vertices, 1.0);
  for (const std::vector<Index>& loop : BoundaryLoops(t)) {
    SlideAlongSides(t, targets, uv, loop, &kept);
  }
  return kept;
}

/// Refines and tells of it; the image may be wound round some vertex then. Errors: cancelled.
Status Refine(const SeamedSurface& of, const Refinement& refinement,
              const std::atomic<bool>* cancelled, CornerUv* uv, MapRefinementSummary* summary) {
  MapRefinement done;
  if (refinement.objective || refinement.stretch) {
    const auto whole =
        refinement.stretch
            ? RefineStretch(of, *refinement.stretch, refinement.of_stretch, cancelled, uv)
            : RefineMap(of, *refinement.objective, refinement.whole, cancelled, uv);
    if (!whole.ok()) return whole.status();
    done = *whole;
    summary->map_refinement_at_rest = done.at_rest ? 1 : 0;
  } else {
    const auto patches = RefineByPatches(of, refinement.patches, cancelled, uv);
    if (!patches.ok()) return patches.status();
    done = *patches;
    summary->map_refinement_flagged = patches->flagged;
    summary->map_refinement_patches = patches->patches;
    summary->map_refinement_rounds = patches->rounds;
    summary->map_refinement_patch_steps = patches->patch_steps;
  }
  summary->map_refinement_steps = done.steps;
  summary->map_refinement_before = done.before;
  summary->map_refinement_after = done.after;
  return Status();
}

constexpr double kMultiple = 1e-12;  ///< [rad]: of targets, which are read with some digits
constexpr double kRotation = 1e-6;   ///< [rad]: of seams, which carry the errors of a solve

/// What is known of a map's overlap.
std::string OverlapOf(const Triangulation& t, const Cut& cut, const CornerUv& uv) {
  if (!FlippedFaces(t, uv).empty()) return "unknown";
  return OverlapsItself(CutOpen(t, cut), uv) ? kOverlaps : kInjective;
}

}  // namespace

std::vector<std::string> RefineMapNames() {
  std::vector<std::string> names = {kByPatches, kNoRefinement};
  for (std::string& objective : MapObjectives().Names()) names.push_back(std::move(objective));
  for (std::string& energy : StretchEnergies().Names()) names.push_back(std::move(energy));
  return names;
}

bool LeavesConformal(const std::string& refine_map) {
  const StatusOr<NameWithOptions> named = ParseNameWithOptions(refine_map);
  return named.ok() && StretchEnergies().Find(named->name).ok();
}

Status CheckRefineMap(const std::string& refine_map) {
  return refine_map == kNoRefinement ? Status() : Parse(refine_map).status();
}

Status RefineLayout(const LaidOutSurface& of, const ConeTargets& targets,
                    const std::string& refine_map, PlanarLayout* layout,
                    std::optional<MapRefinementSummary>* summary) {
  const Triangulation& t = of.surface.triangulation;
  const SeamReport report = MeasureSeams(t, of.cut, of.cones, of.flat.angles, layout->uv);
  KeptVertices kept = KeepPrescribedBoundary(t, targets, report, layout->uv);
  SeamedSurface seamed = {of.surface, of.cut, report.seams, std::move(kept.held),
                          std::move(kept.sliding)};
  seamed.injective = of.injective;
  return RefineSeamedMap(seamed, refine_map, of.cancelled, &layout->uv, summary);
}

Status RefineHeldMap(const IntrinsicSurface& surface, KeptVertices kept,
                     const std::string& refine_map, const std::atomic<bool>* cancelled,
                     CornerUv* uv, std::optional<MapRefinementSummary>* summary) {
  const Cut none{std::vector<bool>(surface.triangulation.num_edges(), false)};
  const SeamedSurface of = {surface, none, {}, std::move(kept.held), std::move(kept.sliding)};
  return RefineSeamedMap(of, refine_map, cancelled, uv, summary);
}

Status RefineSeamedMap(const SeamedSurface& of, const std::string& refine_map,
                       const std::atomic<bool>* cancelled, CornerUv* uv,
                       std::optional<MapRefinementSummary>* summary) {
  if (refine_map == kNoRefinement) return Status();
  const StatusOr<Refinement> refinement = Parse(refine_map);
  if (!refinement.ok()) return refinement.status();
  const CornerUv before = *uv;
  MapRefinementSummary& done = Fill(summary);
  Status status = Refine(of, *refinement, cancelled, uv, &done);
  if (status.ok() && !WoundVertices(CutOpen(of.surface.triangulation, of.cut), *uv).empty()) {
    *uv = before;
    done.map_refinement_steps = 0;
    done.map_refinement_after = done.map_refinement_before;
  }
  return status;
}

SeamSummary SummaryOf(const SeamReport& report) {
  return {static_cast<int>(report.seams.size()), report.max_length_mismatch,
          report.max_rotation_mismatch, report.max_gap, report.max_cone_mismatch};
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

void ScalePieces(const IntrinsicSurface& surface, PlanarLayout* layout) {
  if (layout->patches.count == 1) return;
  const Patches pieces = ConnectedPatches(surface.triangulation);
  if (pieces.count == 1) return;
  CornerUv* const uv = &layout->uv;
  const auto& side = surface.lengths.value;
  const auto& edge = surface.triangulation.edge;
  std::vector<double> own(pieces.count, 0), image(pieces.count, 0);
  for (Index f = 0; f < surface.triangulation.num_faces(); ++f) {
    const Index h = 3 * f, piece = pieces.of_face[f];
    own[piece] += side[edge[h]] * side[edge[h + 1]] * std::sin(surface.angles.value[h + 2]);
    const Eigen::Vector2d a = uv->value[h + 1] - uv->value[h], b = uv->value[h + 2] - uv->value[h];
    image[piece] += a.x() * b.y() - a.y() * b.x();
  }
  for (std::size_t c = 0; c < uv->value.size(); ++c) {
    const Index piece = pieces.of_face[c / 3];
    const double scale = std::sqrt(own[piece] / image[piece]);
    if (std::isnormal(scale)) uv->value[c] *= scale;
  }
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
  certificate->overlap = OverlapOf(t, cut, uv);
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

#include "cirque/pipeline/descend.h"

#include <utility>
#include <vector>

#include "cirque/layout/opened_map.h"
#include "cirque/layout/planar_layout.h"
#include "cirque/layout/refine_map.h"
#include "cirque/layout/seams.h"
#include "cirque/pipeline/convex_start.h"
#include "cirque/pipeline/finish_layout.h"

namespace cirque {
namespace {

/// Towards the flat metric no digits are wanted, but from afar; and room to go on.
constexpr RefineStretchOptions kTowardsFlat = {.steps = 200, .decrease = 3e-3, .least_reach = 0.25};
constexpr double kTooFar = 100;  ///< of the energy where that ends: steps have become too short
/// `area` of weight 0 is mips.
constexpr RefineStretchOptions kConformal = {.steps = 200, .decrease = 1e-3, .weight = 0};

/// A disk whose image is to be injective.
SeamedSurface Injective(const IntrinsicSurface& disk, const Cut& none) {
  static const std::vector<Seam> kNoSeams;
  SeamedSurface of = {disk, none, kNoSeams};
  of.injective = true;
  return of;
}

double MeanMips(const SeamedSurface& of, const CornerUv& uv) {
  return OpenedMap(of, uv, 0).Mean(*MapObjectives().Find("mips"));
}

/// Lowers what is asked for.
Status Finish(const SeamedSurface& of, const std::string& refine_map,
              const std::atomic<bool>* cancelled, Descent* descent) {
  if (LeavesConformal(refine_map)) {
    Status status = RefineSeamedMap(of, refine_map, cancelled, &descent->uv, &descent->refinement);
    if (status.ok()) descent->steps += descent->refinement->map_refinement_steps;
    return status;
  }
  const auto done =
      RefineStretch(of, *StretchEnergies().Find("area"), kConformal, cancelled, &descent->uv);
  if (done.ok()) descent->steps += done->steps;
  return done.status();
}

}  // namespace

StatusOr<Descent> DescendToInjective(const IntrinsicSurface& surface,
                                     const EdgeLengths& flat_lengths, const Cut& cut,
                                     const std::string& refine_map,
                                     const std::atomic<bool>* cancelled) {
  const Triangulation& t = surface.triangulation;
  const Triangulation open = CutOpen(t, cut);
  const Cut none{std::vector<bool>(open.num_edges(), false)};
  const EdgeLengths lengths = OpenedLengths(t, surface.lengths, open);
  const EdgeLengths flat = OpenedLengths(t, flat_lengths, open);
  const IntrinsicSurface disk = MeasureSurface(open, lengths);
  const IntrinsicSurface flat_disk = MeasureSurface(open, flat);
  std::optional<CornerUv> start = EmbedInDisk(flat_disk);
  if (!start) return Status(StatusCode::kUnrepresentable, "doubles hold no embedding in a disk");
  const SeamedSurface of = Injective(disk, none);
  Descent descent;
  descent.uv = *std::move(start);
  descent.before = MeanMips(of, descent.uv);
  const auto towards_flat =
      RefineStretch(Injective(flat_disk, none), *StretchEnergies().Find("symmetric_dirichlet"),
                    kTowardsFlat, cancelled, &descent.uv);
  if (!towards_flat.ok()) return towards_flat.status();
  if (!(towards_flat->after < kTooFar)) {
    return Status(StatusCode::kNotConverged, "descent to an injective image: steps are too short");
  }
  descent.steps = towards_flat->steps;
  if (Status s = Finish(of, refine_map, cancelled, &descent); !s.ok()) return s;
  descent.after = MeanMips(of, descent.uv);
  return descent;
}

}  // namespace cirque

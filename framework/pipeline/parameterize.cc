#include "cirque/pipeline/parameterize.h"

#include <utility>

#include <fmt/format.h>

#include "cirque/core/text.h"
#include "cirque/core/timer.h"
#include "cirque/cuts/check_cut.h"
#include "cirque/cuts/cut_graph.h"
#include "cirque/layout/planar_layout.h"
#include "cirque/layout/seams.h"
#include "cirque/mesh/simple_cones.h"
#include "cirque/metrics/distortion.h"
#include "cirque/metrics/injectivity.h"

namespace cirque {
namespace {

/// The given cut, or one through the cones, short in the flat metric.
StatusOr<Cut> ChooseCut(const Triangulation& t, const FlatOnInput& flat,
                        const std::vector<Index>& cones, const Cut* given) {
  if (!given) return CutGraph(t, flat.lengths.value, cones);
  if (Status s = CheckCut(t, *given, cones); !s.ok()) return s;
  return *given;
}

Status Unrepresentable(const Certificate& certificate, const std::vector<Index>& flipped) {
  return Status(
      StatusCode::kUnrepresentable,
      fmt::format(
          "the flat metric exists but doubles cannot hold it in one chart: log radii range "
          "over {:.1f} and {} faces collapse, faces {} (0-based) among them; add cones there",
          certificate.values.at("log_radius_range"), flipped.size(), IdList(flipped, 5)));
}

/// Cuts and lays out; refuses a layout with a flipped triangle.
Status LayOut(const Triangulation& t, const ConeTargets& targets, const Cut* given,
              Parameterization* result) {
  Certificate& certificate = result->certificate;
  const FlatOnInput& flat = result->flat.on_input;
  const std::vector<Index> cones = ConeVertices(t, targets);
  StatusOr<Cut> cut = ChooseCut(t, flat, cones, given);
  if (!cut.ok()) return cut.status();
  PlanarLayout layout = LayOutPatches(t, flat.angles, flat.lengths, *cut);
  const SeamReport seams = MeasureSeams(t, *cut, cones, flat.angles, layout.uv);
  const std::vector<Index> flipped = FlippedFaces(t, layout.uv);
  certificate.values.merge(
      std::map<std::string, double>{{"cones", static_cast<double>(cones.size())},
                                    {"patches", static_cast<double>(layout.patches.count)},
                                    {"seams", static_cast<double>(seams.seams.size())},
                                    {"seam_length_mismatch", seams.max_length_mismatch},
                                    {"seam_rotation_mismatch", seams.max_rotation_mismatch},
                                    {"seam_gap", seams.max_gap},
                                    {"cone_rotation_mismatch", seams.max_cone_mismatch},
                                    {"layout_closure", layout.closure},
                                    {"flipped_triangles", static_cast<double>(flipped.size())}});
  if (!flipped.empty()) return Unrepresentable(certificate, flipped);
  result->cut = *std::move(cut);
  result->uv = std::move(layout.uv);
  return Status();
}

void Measure(const Triangulation& t, const EdgeLengths& lengths, Parameterization* result) {
  const Triangulation opened = CutOpen(t, result->cut);
  Certificate& certificate = result->certificate;
  certificate.overlap =
      BoundaryCrossings(opened, result->uv).empty() ? "injective" : "boundary_overlaps";
  const DistortionSummary d = Summarize(MeasureDistortion(t, lengths, result->uv));
  certificate.values.merge(
      std::map<std::string, double>{{"quasi_conformal_mean", d.quasi_conformal_mean},
                                    {"quasi_conformal_max", d.quasi_conformal_max},
                                    {"log_area_ratio_l2", d.log_area_ratio_l2},
                                    {"log_area_ratio_min", d.log_area_ratio_min},
                                    {"log_area_ratio_max", d.log_area_ratio_max}});
}

Status Run(const Surface& surface, const ConeTargets& targets, const Cut* cut,
           const ParameterizeOptions& options, const SolveControl& control,
           Parameterization* result) {
  const Triangulation& t = surface.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  Certificate& certificate = result->certificate;
  Status status = Flatten(t, lengths, targets, options, control, &certificate, &result->flat);
  if (!status.ok()) return status;
  const Timer layout_timer;
  status = LayOut(t, targets, cut, result);
  certificate.seconds["layout"] += layout_timer.Seconds();
  if (!status.ok()) return status;
  const Timer measure_timer;
  Measure(t, lengths, result);
  certificate.seconds["measures"] = measure_timer.Seconds();
  return status;
}

/// Renumbers the proof's vertices as the input file has them.
void NumberAsInFile(const Surface& surface, InfeasibilityProof* proof) {
  for (Index& v : proof->constrained_vertex) v = surface.soup_vertex[v];
  for (Index& v : proof->carrying_vertices) v = surface.soup_vertex[v];
}

}  // namespace

StatusOr<ConeTargets> DefaultTargets(const Surface& surface) {
  const Triangulation& t = surface.triangulation;
  if (!BoundaryLoops(t).empty()) return FreeBoundaryTargets(t);
  return SimpleConeTargets(t, MeasureEdgeLengths(surface));
}

Status Parameterize(const Surface& surface, const ConeTargets& targets, const Cut* cut,
                    const ParameterizeOptions& options, const SolveControl& control,
                    Parameterization* result) {
  *result = Parameterization();
  const Timer timer;
  const Status status = Run(surface, targets, cut, options, control, result);
  Certificate& certificate = result->certificate;
  certificate.seconds["total"] = timer.Seconds();
  certificate.outcome = ToString(status.code());
  certificate.message = status.message();
  NumberAsInFile(surface, &certificate.infeasibility);
  return status;
}

}  // namespace cirque

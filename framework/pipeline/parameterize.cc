#include "cirque/pipeline/parameterize.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/text.h"
#include "cirque/core/timer.h"
#include "cirque/cuts/check_cut.h"
#include "cirque/cuts/cut_graph.h"
#include "cirque/layout/packing.h"
#include "cirque/layout/planar_layout.h"
#include "cirque/layout/poisson_layout.h"
#include "cirque/layout/seams.h"
#include "cirque/mesh/corner_angles.h"
#include "cirque/mesh/simple_cones.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/measure_map.h"

namespace cirque {
namespace {

constexpr double kFlatness = 1e-6;  ///< [rad]: a vertex closer to 2 pi is no cone

/// The given cut, or one through the cones, short in the flat metric.
StatusOr<Cut> ChooseCut(const Triangulation& t, const FlatOnInput& flat,
                        const std::vector<Index>& cones, const Cut* given) {
  if (!given) return CutGraph(t, flat.lengths.value, cones);
  if (Status s = CheckCut(t, *given, cones); !s.ok()) return s;
  return *given;
}

StatusOr<PlanarLayout> LayOutBy(const std::string& method, const Triangulation& t,
                                const FlatOnInput& flat, const Cut& cut) {
  if (method == "directions") return LayOutPatches(t, flat.angles, flat.lengths, cut);
  if (method == "least_squares") return LayOutByLeastSquares(t, flat.angles, flat.lengths, cut);
  return Status::InvalidInput(UnknownName("layout", method, {"directions", "least_squares"}));
}

Status Unrepresentable(const Certificate& certificate, const std::vector<Index>& flipped) {
  return Status(
      StatusCode::kUnrepresentable,
      fmt::format(
          "the flat metric exists but doubles cannot hold it in one chart: log radii range "
          "over {:.1f} and {} faces collapse, faces {} (0-based) among them; add cones there",
          certificate.values.at("log_radius_range"), flipped.size(), IdList(flipped, 5)));
}

/// Cuts and lays out, several patches side by side in the unit square; refuses a layout with a
/// flipped triangle.
Status LayOut(const Triangulation& t, const ConeTargets& targets, const Cut* given,
              const std::string& method, Parameterization* result) {
  Certificate& certificate = result->certificate;
  const FlatOnInput& flat = result->flat.on_input;
  const std::vector<Index> cones = ConeVertices(t, targets);
  StatusOr<Cut> cut = ChooseCut(t, flat, cones, given);
  if (!cut.ok()) return cut.status();
  StatusOr<PlanarLayout> laid_out = LayOutBy(method, t, flat, *cut);
  if (!laid_out.ok()) return laid_out.status();
  PlanarLayout& layout = *laid_out;
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
  result->uv = layout.patches.count > 1 ? PackPatches(layout.uv, layout.patches, {}).uv
                                        : std::move(layout.uv);
  return Status();
}

Status LayOutAndMeasure(const Triangulation& t, const EdgeLengths& lengths,
                        const ConeTargets& targets, const Cut* cut, const std::string& layout,
                        Parameterization* result) {
  Certificate& certificate = result->certificate;
  const Timer layout_timer;
  const Status status = LayOut(t, targets, cut, layout, result);
  certificate.seconds["layout"] += layout_timer.Seconds();
  if (!status.ok()) return status;
  const Timer measure_timer;
  MeasureMap(t, lengths, result);
  certificate.seconds["measures"] = measure_timer.Seconds();
  return status;
}

Status Run(const Triangulation& t, const EdgeLengths& lengths, const ConeTargets& targets,
           const Cut* cut, const ParameterizeOptions& options, const SolveControl& control,
           Parameterization* result) {
  const Status status =
      Flatten(t, lengths, targets, options, control, &result->certificate, &result->flat);
  return status.ok() ? LayOutAndMeasure(t, lengths, targets, cut, options.layout, result) : status;
}

/// The angle sums of a metric, cones being what differs from flat by more than rounding.
ConeTargets MeasuredTargets(const Triangulation& t, const CornerAngles& angles) {
  ConeTargets targets = FreeBoundaryTargets(t);
  const std::vector<bool> boundary = BoundaryVertices(t);
  std::vector<double> sum(t.num_vertices, 0);
  for (Index h = 0; h < t.num_halfedges(); ++h) sum[t.vertex[h]] += angles.value[h];
  for (Index v = 0; v < t.num_vertices; ++v) {
    const bool cone = !boundary[v] && std::abs(sum[v] - 2 * kPi) > kFlatness;
    if (cone) targets.lower[v] = targets.upper[v] = sum[v];
  }
  return targets;
}

}  // namespace

StatusOr<ConeTargets> DefaultTargets(const Triangulation& t, const EdgeLengths& lengths) {
  if (!BoundaryLoops(t).empty()) return FreeBoundaryTargets(t);
  return SimpleConeTargets(t, lengths);
}

StatusOr<ConeTargets> DefaultTargets(const Surface& surface) {
  return DefaultTargets(surface.triangulation, MeasureEdgeLengths(surface));
}

Status Parameterize(const Triangulation& t, const EdgeLengths& lengths, const ConeTargets& targets,
                    const Cut* cut, const ParameterizeOptions& options, const SolveControl& control,
                    Parameterization* result) {
  *result = Parameterization();
  const Timer timer;
  return Conclude(Run(t, lengths, targets, cut, options, control, result), timer,
                  &result->certificate);
}

Status Parameterize(const Surface& surface, const ConeTargets& targets, const Cut* cut,
                    const ParameterizeOptions& options, const SolveControl& control,
                    Parameterization* result) {
  const Status status = Parameterize(surface.triangulation, MeasureEdgeLengths(surface), targets,
                                     cut, options, control, result);
  NumberAsInFile(surface, &result->certificate.infeasibility);
  return status;
}

Status LayOutFlatMetric(const Triangulation& t, const EdgeLengths& lengths, const Cut* cut,
                        Parameterization* result) {
  *result = Parameterization();
  const Timer timer;
  FlatSurface& flat = result->flat;
  flat.intrinsic = {t, lengths, {}, {}};
  flat.intrinsic_lengths = lengths;
  flat.on_input = {MeasureCornerAngles(t, lengths), lengths, {}};
  const ConeTargets targets = MeasuredTargets(t, flat.on_input.angles);
  result->certificate.values["log_radius_range"] = 0;
  return Conclude(LayOutAndMeasure(t, lengths, targets, cut, ParameterizeOptions().layout, result),
                  timer, &result->certificate);
}

}  // namespace cirque

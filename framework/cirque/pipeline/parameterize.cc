#include "cirque/pipeline/parameterize.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/solve_summary.h"
#include "cirque/core/text.h"
#include "cirque/cuts/cut_graph.h"
#include "cirque/intrinsic/corner_angles.h"
#include "cirque/layout/linear_layout.h"
#include "cirque/layout/packing.h"
#include "cirque/layout/planar_layout.h"
#include "cirque/layout/seams.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/cut_costs.h"
#include "cirque/pipeline/map_measures.h"
#include "cirque/pipeline/place_cones.h"
#include "cirque/pipeline/refine_cones.h"
#include "cirque/pipeline/refine_layout.h"
#include "cirque/pipeline/repair_cones.h"
#include "cirque/pipeline/snap_rotations.h"

namespace cirque {
namespace {

constexpr double kFlatness = 1e-6;  ///< [rad]: a vertex closer to 2 pi is no cone

/// What is parameterized, and how.
struct Job {
  const Triangulation& t;
  const EdgeLengths& lengths;
  const FileVertices& file;
  const Cut* cut;  ///< null: a short one is sought
  const ParameterizeOptions& options;
  const SolveControl& control;
};

/// The given cut, or one through the cones, short by the costs that the options name.
StatusOr<Cut> ChooseCut(const Job& job, const InputChart& flat, const std::vector<Index>& cones) {
  if (job.cut) {
    if (Status s = CheckCut(job.t, *job.cut, cones); !s.ok()) return s;
    return *job.cut;
  }
  const StatusOr<Eigen::VectorXd> costs =
      CutCosts(job.t, job.lengths, flat.lengths, job.options, job.file.of_vertex);
  if (!costs.ok()) return costs.status();
  return CutGraph(job.t, *costs, cones);
}

StatusOr<PlanarLayout> LayOutBy(LayoutMethod method, const Triangulation& t, const InputChart& flat,
                                const Cut& cut) {
  if (method == LayoutMethod::kDirections) return LayOutPatches(t, flat.angles, flat.lengths, cut);
  return LayOutByLeastSquares(t, flat.angles, flat.lengths, cut);
}

Status Unrepresentable(const Certificate& certificate, const std::vector<Index>& flipped) {
  return Status(
      StatusCode::kUnrepresentable,
      fmt::format(
          "the flat metric exists but doubles cannot hold it in one chart: log radii range "
          "over {:.1f} and {} faces collapse, faces {} (0-based) among them; add cones there",
          certificate.values.at("log_radius_range"), flipped.size(), IdList(flipped, 5)));
}

/// Several patches, each in a frame of its own: side by side. One patch: exact rotations across the
/// seams where the cones' angles allow it.
void Arrange(const Triangulation& t, const ConeTargets& targets, const std::vector<Index>& cones,
             const InputChart& flat, const Cut& cut, PlanarLayout* layout,
             Certificate* certificate) {
  certificate->values["rotation_order"] = 0;
  if (layout->patches.count > 1) {
    layout->uv = PackPatches(layout->uv, layout->patches, {}).uv;
    return;
  }
  const int order = CommonRotationOrder(targets, cones);
  if (order > 0 && SnapRotations(t, cut, cones, flat.angles, order, &layout->uv)) {
    certificate->values["rotation_order"] = order;
  }
}

/// Cuts and lays out, several patches side by side in the unit square; refuses a layout with a
/// flipped triangle.
Status CutAndPlace(const Job& job, Parameterization* result) {
  const Triangulation& t = job.t;
  Certificate& certificate = result->certificate;
  const InputChart& flat = result->flat.on_input;
  const std::vector<Index> cones = ConeVertices(t, result->targets);
  StatusOr<Cut> cut = ChooseCut(job, flat, cones);
  if (!cut.ok()) return cut.status();
  StatusOr<PlanarLayout> laid_out = LayOutBy(job.options.layout, t, flat, *cut);
  if (!laid_out.ok()) return laid_out.status();
  PlanarLayout& layout = *laid_out;
  std::vector<Index> flipped = FlippedFaces(t, layout.uv);
  if (flipped.empty()) {
    Status refined = RefineLayout(t, job.lengths, flat, *cut, cones, job.options.refine_map,
                                  job.control.cancelled, &layout, &certificate);
    if (!refined.ok()) return refined;
    Arrange(t, result->targets, cones, flat, *cut, &layout, &certificate);
    flipped = FlippedFaces(t, layout.uv);
  }
  const SeamReport seams = MeasureSeams(t, *cut, cones, flat.angles, layout.uv);
  certificate.values.merge(
      std::map<std::string, double>{{"cones", static_cast<double>(cones.size())},
                                    {"cut_length", RelativeCutLength(t, job.lengths, *cut)},
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

/// The same, timed.
Status LayOut(const Job& job, Parameterization* result) {
  const Timer timer;
  Status status = CutAndPlace(job, result);
  result->certificate.seconds["layout"] += timer.Seconds();
  return status;
}

Status FlattenAsAsked(const Job& job, Parameterization* result) {
  return Flatten(job.t, job.lengths, result->targets, job.options, job.control,
                 &result->certificate, &result->flat);
}

/// Flattens and lays out the surface opened along the cut, whose boundary then is free. It has
/// coherent angles where the whole one has them on the same connectivity; a proof that it has none
/// would be no proof about the input.
Status FreeSeams(const Job& job, Parameterization* result) {
  const std::vector<Index> cones = ConeVertices(job.t, result->targets);
  StatusOr<Cut> cut = ChooseCut(job, result->flat.on_input, cones);
  if (!cut.ok()) return cut.status();
  const Triangulation open = CutOpen(job.t, *cut);
  const EdgeLengths lengths = OpenedLengths(job.t, job.lengths, open);
  const Cut none{std::vector<bool>(open.num_edges(), false)};
  const Job opened{open, lengths, job.file, &none, job.options, job.control};
  result->targets = FreeBoundaryTargets(open);
  Status status = FlattenAsAsked(opened, result);
  if (status.ok()) status = LayOut(opened, result);
  if (status.code() == StatusCode::kInfeasible) {
    result->certificate.infeasibility = {};
    return Status(StatusCode::kNotConverged,
                  "the surface opened along its cut has no coherent angles on its connectivity; "
                  "the whole one has: keep rigid seams");
  }
  auto& values = result->certificate.values;
  values["cones"] = static_cast<double>(cones.size());
  values["cut_length"] = RelativeCutLength(job.t, job.lengths, *cut);
  result->cut = *std::move(cut);
  return status;
}

Status LayOutAndMeasure(const Job& job, Parameterization* result) {
  Status status =
      job.options.seams == SeamKind::kFree ? FreeSeams(job, result) : LayOut(job, result);
  if (!status.ok()) return status;
  const Timer measure_timer;
  PutMeasures(job.t, job.lengths, result);
  result->certificate.seconds["measures"] = measure_timer.Seconds();
  return status;
}

Status Run(const Job& job, Parameterization* result) {
  if (job.options.refine_cones > 0) {
    const Timer timer;
    Status status = RefineCones(job.t, job.lengths, job.options, job.control, &result->certificate,
                                &result->targets, &result->flat);
    result->certificate.seconds["refine_cones"] = timer.Seconds();
    if (!status.ok()) return status;
  }
  return LayOutAndMeasure(job, result);
}

Status RunWithTargets(const Job& job, Parameterization* result) {
  if (Status s = ParameterizeOptionTable().Validate(job.options); !s.ok()) return s;
  Status status = FlattenAsAsked(job, result);
  return status.ok() ? Run(job, result) : status;
}

/// Cones that the program chose and that turn out infeasible are changed until they are feasible.
Status FlattenAndRepair(const Job& job, Parameterization* result) {
  Status status = FlattenAsAsked(job, result);
  auto& values = result->certificate.values;
  for (int round = 1; round <= kMostConeRepairs; ++round) {
    const InfeasibilityCertificate proof = result->certificate.infeasibility;
    if (status.code() != StatusCode::kInfeasible || proof.empty()) break;
    ConeRepair repair = RepairCones(job.t, result->targets, proof, round);
    if (repair.moved + repair.widened == 0) continue;
    values["cone_repairs"] = round;
    values["cones_moved"] += repair.moved;
    values["cones_widened"] = repair.widened;
    result->targets = std::move(repair.targets);
    status = FlattenAsAsked(job, result);
  }
  return status;
}

Status RunWithCones(const Job& job, Parameterization* result) {
  if (Status s = CheckOptions(job.options); !s.ok()) return s;
  const Timer timer;
  StatusOr<ConeTargets> targets = PlaceCones(job.t, job.lengths, job.file, job.options);
  result->certificate.seconds["cones"] = timer.Seconds();
  if (!targets.ok()) return targets.status();
  result->targets = *std::move(targets);
  Status status = FlattenAndRepair(job, result);
  return status.ok() ? Run(job, result) : status;
}

Status RunRequest(const Triangulation& t, const EdgeLengths& lengths, const FileVertices& file,
                  const ParameterizeRequest& request, const SolveControl& control,
                  Parameterization* result) {
  *result = Parameterization();
  const Job job{t, lengths, file, request.cut ? &*request.cut : nullptr, request.options, control};
  if (!request.targets) return RunWithCones(job, result);
  result->targets = *request.targets;
  return RunWithTargets(job, result);
}

/// The angle sums of a metric, cones being what differs from flat by more than rounding.
ConeTargets MeasuredTargets(const Triangulation& t, const CornerAngles& angles) {
  ConeTargets targets = FreeBoundaryTargets(t);
  const std::vector<bool> boundary = BoundaryVertices(t);
  const std::vector<double> sum = VertexAngleSums(t, angles);
  for (Index v = 0; v < t.num_vertices; ++v) {
    const bool cone = !boundary[v] && std::abs(sum[v] - 2 * kPi) > kFlatness;
    if (cone) targets.lower[v] = targets.upper[v] = sum[v];
  }
  return targets;
}

/// Isolated vertices behind the last used one are unknown here, and no cone can lie there.
FileVertices VerticesInFile(const Surface& surface) {
  const auto& number = surface.soup_vertex;
  return {number.empty() ? 0 : *std::max_element(number.begin(), number.end()) + 1, number};
}

}  // namespace

StatusOr<ConeTargets> DefaultTargets(const Surface& surface) {
  return DefaultTargets(surface.triangulation, MeasureEdgeLengths(surface));
}

Status Parameterize(const Triangulation& t, const EdgeLengths& lengths,
                    const ParameterizeRequest& request, const SolveControl& control,
                    Parameterization* result) {
  const Timer timer;
  const FileVertices file = VerticesInOrder(t.num_vertices);
  return Conclude(RunRequest(t, lengths, file, request, control, result), timer,
                  &result->certificate);
}

Status Parameterize(const Surface& surface, const ParameterizeRequest& request,
                    const SolveControl& control, Parameterization* result) {
  const Timer timer;
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const FileVertices file = VerticesInFile(surface);
  Status status = RunRequest(surface.triangulation, lengths, file, request, control, result);
  NumberAsInFile(surface, &result->certificate.infeasibility);
  return Conclude(status, timer, &result->certificate);
}

Status LayOutFlatMetric(const Triangulation& t, const EdgeLengths& lengths, const Cut* cut,
                        Parameterization* result) {
  *result = Parameterization();
  const Timer timer;
  FlatSurface& flat = result->flat;
  flat.intrinsic = {t, lengths, {}, {}};
  flat.intrinsic_lengths = lengths;
  flat.on_input = {MeasureCornerAngles(t, lengths), lengths, {}};
  result->targets = MeasuredTargets(t, flat.on_input.angles);
  result->certificate.values["log_radius_range"] = 0;
  const FileVertices file = VerticesInOrder(t.num_vertices);
  const ParameterizeOptions plain;
  const SolveControl control;
  return Conclude(LayOutAndMeasure({t, lengths, file, cut, plain, control}, result), timer,
                  &result->certificate);
}

}  // namespace cirque

#include "cirque/pipeline/parameterize.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/solve_summary.h"
#include "cirque/core/text.h"
#include "cirque/cuts/cut_graph.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/layout/linear_layout.h"
#include "cirque/layout/planar_layout.h"
#include "cirque/layout/seams.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/cone_stages.h"
#include "cirque/pipeline/cut_costs.h"
#include "cirque/pipeline/finish_layout.h"

namespace cirque {
namespace {

constexpr char kConesForRange[] = "greedy";
constexpr double kFlatness = 1e-6;  ///< [rad]: a vertex closer to 2 pi is no cone

/// What is parameterized, and how.
struct Job {
  const IntrinsicSurface& surface;
  const FileVertices& file;
  const Cut* cut;  ///< null: a short one is sought
  const ParameterizeOptions& options;
  const SolveControl& control;
};

/// The given cut, or one through the cones, short by the costs that the options name.
StatusOr<Cut> ChooseCut(const Job& job, const InputChart& flat, const std::vector<Index>& cones) {
  if (job.cut) {
    if (Status s = CheckCut(job.surface.triangulation, *job.cut, cones); !s.ok()) return s;
    return *job.cut;
  }
  const StatusOr<Eigen::VectorXd> costs =
      CutCosts(job.surface, flat.lengths, job.options, job.file.of_vertex);
  if (!costs.ok()) return costs.status();
  return CutGraph(job.surface.triangulation, *costs, cones);
}

StatusOr<PlanarLayout> LayOutBy(LayoutMethod method, const Triangulation& t, const InputChart& flat,
                                const Cut& cut) {
  if (method == LayoutMethod::kDirections) return LayOutPatches(t, flat.angles, flat.lengths, cut);
  return LayOutByLeastSquares(t, flat.angles, flat.lengths, cut);
}

Status Unrepresentable(const LogRadii& radii, const std::vector<Index>& flipped) {
  const Eigen::VectorXd& rho = radii.value;
  const double range = rho.size() > 0 ? rho.maxCoeff() - rho.minCoeff() : 0;
  return Status(
      StatusCode::kUnrepresentable,
      fmt::format(
          "the flat metric exists but doubles cannot hold it in one chart: log radii range "
          "over {:.1f} and {} faces collapse, faces {} (0-based) among them; add cones there",
          range, flipped.size(), IdList(flipped, 5)));
}

SeamSummary SummaryOf(const SeamReport& report) {
  return {static_cast<int>(report.seams.size()), report.max_length_mismatch,
          report.max_rotation_mismatch, report.max_gap, report.max_cone_mismatch};
}

/// Cuts and lays out, several patches side by side in the unit square; refuses a layout with a
/// flipped triangle.
Status CutAndPlace(const Job& job, Parameterization* result) {
  const Triangulation& t = job.surface.triangulation;
  Certificate& certificate = result->certificate;
  const InputChart& flat = result->flat.on_input;
  const std::vector<Index> cones = ConeVertices(job.surface.boundary, result->targets);
  StatusOr<Cut> cut = ChooseCut(job, flat, cones);
  if (!cut.ok()) return cut.status();
  StatusOr<PlanarLayout> laid_out = LayOutBy(job.options.layout, t, flat, *cut);
  if (!laid_out.ok()) return laid_out.status();
  PlanarLayout& layout = *laid_out;
  LayoutSummary& summary = Fill(&certificate.layout);
  std::vector<Index> flipped = FlippedFaces(t, layout.uv);
  if (flipped.empty()) {
    const LaidOutSurface of = {job.surface, flat, *cut, cones, job.control.cancelled};
    Status refined = RefineLayout(of, result->targets, job.options.refine_map, &layout,
                                  &certificate.map_refinement);
    if (!refined.ok()) return refined;
    summary.rotation_order = ArrangePatches(of, result->targets, &layout);
    flipped = FlippedFaces(t, layout.uv);
  }
  certificate.seams = SummaryOf(MeasureSeams(t, *cut, cones, flat.angles, layout.uv));
  summary.layout_closure = layout.closure;
  summary.flipped_triangles = static_cast<int>(flipped.size());
  summary.cones = static_cast<int>(cones.size());
  summary.patches = static_cast<int>(layout.patches.count);
  summary.cut_length = RelativeCutLength(job.surface, *cut);
  if (!flipped.empty()) return Unrepresentable(result->flat.log_radii, flipped);
  result->cut = *std::move(cut);
  result->uv = std::move(layout.uv);
  return Status();
}

/// The same, timed.
Status LayOut(const Job& job, Parameterization* result) {
  const Timer timer;
  Status status = CutAndPlace(job, result);
  AddSeconds(timer, &result->certificate.seconds.layout);
  return status;
}

Status FlattenAsAsked(const Job& job, Parameterization* result) {
  return Flatten({job.surface, result->targets, job.options, job.control}, &result->certificate,
                 &result->flat);
}

/// Flattens and lays out the surface opened along the cut, whose boundary then is free. It has
/// coherent angles where the whole one has them on the same connectivity; a proof that it has none
/// would be no proof about the input.
Status FreeSeams(const Job& job, Parameterization* result) {
  const Triangulation& t = job.surface.triangulation;
  const std::vector<Index> cones = ConeVertices(job.surface.boundary, result->targets);
  StatusOr<Cut> cut = ChooseCut(job, result->flat.on_input, cones);
  if (!cut.ok()) return cut.status();
  const Triangulation open = CutOpen(t, *cut);
  const EdgeLengths lengths = OpenedLengths(t, job.surface.lengths, open);
  const IntrinsicSurface surface = MeasureSurface(open, lengths);
  const Cut none{std::vector<bool>(open.num_edges(), false)};
  const Job opened{surface, job.file, &none, job.options, job.control};
  result->targets = FreeBoundaryTargets(open);
  Status status = FlattenAsAsked(opened, result);
  if (status.ok()) status = LayOut(opened, result);
  if (status.code() == StatusCode::kInfeasible) {
    result->flat.infeasibility = {};
    return Status(StatusCode::kNotConverged,
                  "the surface opened along its cut has no coherent angles on its connectivity; "
                  "the whole one has: keep rigid seams");
  }
  LayoutSummary& summary = Fill(&result->certificate.layout);
  summary.cones = static_cast<int>(cones.size());
  summary.cut_length = RelativeCutLength(job.surface, *cut);
  result->cut = *std::move(cut);
  return status;
}

Status LayOutAndMeasure(const Job& job, Parameterization* result) {
  Status status =
      job.options.seams == SeamKind::kFree ? FreeSeams(job, result) : LayOut(job, result);
  if (!status.ok()) return status;
  const Timer measure_timer;
  MeasureDistortion(job.surface.triangulation, job.surface.lengths, result->cut, result->uv,
                    &result->certificate);
  result->certificate.seconds.measures = measure_timer.Seconds();
  return status;
}

Status Run(const Job& job, Parameterization* result) {
  if (job.options.refine_cones > 0) {
    const Timer timer;
    Status status = RefineCones({job.surface, result->targets, job.options, job.control},
                                &result->certificate, &result->targets, &result->flat);
    result->certificate.seconds.refine_cones = timer.Seconds();
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
  for (int round = 1; round <= kMostConeRepairs; ++round) {
    const InfeasibilityCertificate& proof = result->flat.infeasibility;
    if (status.code() != StatusCode::kInfeasible || proof.empty()) break;
    ConeRepair repair = RepairCones(job.surface, result->targets, proof, round);
    if (repair.moved + repair.widened == 0) continue;
    ConeRepairSummary& summary = Fill(&result->certificate.cone_repair);
    summary.cone_repairs = round;
    summary.cones_moved += repair.moved;
    summary.cones_widened = repair.widened;
    result->targets = std::move(repair.targets);
    status = FlattenAsAsked(job, result);
  }
  return status;
}

Status RunWithChosenCones(const Job& job, Parameterization* result) {
  const Timer timer;
  StatusOr<ConeTargets> targets = PlaceCones(job.surface, job.file, job.options);
  result->certificate.seconds.cones = timer.Seconds();
  if (!targets.ok()) return targets.status();
  result->targets = *std::move(targets);
  Status status = FlattenAndRepair(job, result);
  return status.ok() ? Run(job, result) : status;
}

/// Where nobody asked for cones and doubles cannot hold the map, or not to kAccuracy: the same with
/// cones that a heuristic chooses, kept if that makes a better one.
Status RunWithCones(const Job& job, Parameterization* result) {
  if (Status s = CheckOptions(job.options); !s.ok()) return s;
  const Status status = RunWithChosenCones(job, result);
  const bool unrepresentable = status.code() == StatusCode::kUnrepresentable;
  if (!job.options.cones.empty()) return status;
  if (!unrepresentable && (!status.ok() || Inaccuracy(result->certificate).empty())) return status;
  ParameterizeOptions options = job.options;
  options.cones = kConesForRange;
  Parameterization other;
  const Status with_cones =
      RunWithChosenCones({job.surface, job.file, job.cut, options, job.control}, &other);
  if (with_cones.code() == StatusCode::kCancelled) return with_cones;
  if (!with_cones.ok()) return status;
  if (!unrepresentable && !Inaccuracy(other.certificate).empty()) return status;
  Fill(&other.certificate.cone_repair).cones_for_range = 1;
  *result = std::move(other);
  return with_cones;
}

Status RunRequest(const IntrinsicSurface& surface, const FileVertices& file,
                  const ParameterizeRequest& request, const SolveControl& control,
                  Parameterization* result) {
  *result = Parameterization();
  const Job job{surface, file, request.cut ? &*request.cut : nullptr, request.options, control};
  Status status;
  if (request.targets) {
    result->targets = *request.targets;
    status = RunWithTargets(job, result);
  } else {
    status = RunWithCones(job, result);
  }
  result->certificate.infeasibility = std::move(result->flat.infeasibility);
  return status;
}

/// The angle sums of a metric, cones being what differs from flat by more than rounding.
ConeTargets MeasuredTargets(const IntrinsicSurface& surface) {
  ConeTargets targets = FreeBoundaryTargets(surface.triangulation);
  const std::vector<double> sum = VertexAngleSums(surface.triangulation, surface.angles);
  for (Index v = 0; v < surface.triangulation.num_vertices; ++v) {
    const bool cone = !surface.boundary[v] && std::abs(sum[v] - 2 * kPi) > kFlatness;
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
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  return DefaultTargets(MeasureSurface(surface.triangulation, lengths));
}

Status Parameterize(const Triangulation& t, const EdgeLengths& lengths,
                    const ParameterizeRequest& request, const SolveControl& control,
                    Parameterization* result) {
  const Timer timer;
  const FileVertices file = VerticesInOrder(t.num_vertices);
  return Conclude(RunRequest(MeasureSurface(t, lengths), file, request, control, result), timer,
                  &result->certificate);
}

Status Parameterize(const Surface& surface, const ParameterizeRequest& request,
                    const SolveControl& control, Parameterization* result) {
  const Timer timer;
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const FileVertices file = VerticesInFile(surface);
  const IntrinsicSurface intrinsic = MeasureSurface(surface.triangulation, lengths);
  Status status = RunRequest(intrinsic, file, request, control, result);
  NumberAsInFile(surface, &result->certificate.infeasibility);
  return Conclude(status, timer, &result->certificate);
}

Status LayOutFlatMetric(const Triangulation& t, const EdgeLengths& lengths, const Cut* cut,
                        Parameterization* result) {
  *result = Parameterization();
  const Timer timer;
  const IntrinsicSurface surface = MeasureSurface(t, lengths);
  FlatSurface& flat = result->flat;
  flat.intrinsic = {t, lengths, {}, {}};
  flat.intrinsic_lengths = lengths;
  flat.on_input = {surface.angles, lengths, {}};
  result->targets = MeasuredTargets(surface);
  const FileVertices file = VerticesInOrder(t.num_vertices);
  ParameterizeOptions plain;
  plain.refine_map = "none";
  const SolveControl control;
  return Conclude(LayOutAndMeasure({surface, file, cut, plain, control}, result), timer,
                  &result->certificate);
}

}  // namespace cirque

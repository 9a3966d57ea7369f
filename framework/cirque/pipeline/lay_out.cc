#include "cirque/pipeline/lay_out.h"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cirque/core/solve_summary.h"
#include "cirque/core/text.h"
#include "cirque/cuts/cut_graph.h"
#include "cirque/layout/linear_layout.h"
#include "cirque/layout/planar_layout.h"
#include "cirque/layout/seams.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/cut_costs.h"
#include "cirque/pipeline/finish_layout.h"
#include "cirque/pipeline/flatten.h"

namespace cirque {
namespace {

using Job = ParameterizeJob;

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

/// Flattens and lays out an opened surface. A proof that it has no coherent angles would be no proof
/// about the input.
Status FlattenAndLayOut(const Job& opened, Parameterization* result) {
  Status status = FlattenToTargets(opened, result);
  if (status.ok()) status = LayOut(opened, result);
  if (status.code() != StatusCode::kInfeasible) return status;
  result->flat.infeasibility = {};
  return Status(StatusCode::kNotConverged,
                "the surface opened along its cut has no coherent angles on its connectivity; keep "
                "rigid seams");
}

/// Flattens and lays out the surface opened along the cut, whose boundary then is free. It has
/// coherent angles where the whole one has them on the same connectivity.
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
  const Status status = FlattenAndLayOut(opened, result);
  LayoutSummary& summary = Fill(&result->certificate.layout);
  summary.cones = static_cast<int>(cones.size());
  summary.cut_length = RelativeCutLength(job.surface, *cut);
  result->cut = *std::move(cut);
  return status;
}

/// The numbers that the vertices of the surface opened have in the file of the whole one.
FileVertices NumbersOfOpened(const Triangulation& t, const FileVertices& file,
                             const Triangulation& open) {
  FileVertices numbers{file.count, std::vector<Index>(open.num_vertices, kNone)};
  if (file.of_vertex.empty()) return {file.count, {}};
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    numbers.of_vertex[open.vertex[h]] = file.of_vertex[t.vertex[h]];
  }
  return numbers;
}

/// The given cut with what opens further: edges of the surface opened along it.
Cut Joined(const Triangulation& t, const Cut& given, const Triangulation& open,
           const Cut& further) {
  Cut both = given;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (further.edge[open.edge[h]]) both.edge[t.edge[h]] = true;
  }
  return both;
}

void Measure(const Job& job, Parameterization* result) {
  const Timer measure_timer;
  LayoutSummary& summary = Fill(&result->certificate.layout);
  summary.float32_vanishing_triangles =
      static_cast<int>(FlippedFacesInFloat32(job.surface.triangulation, result->uv).size());
  MeasureDistortion(job.surface.triangulation, job.surface.lengths, result->cut, result->uv,
                    &result->certificate);
  result->certificate.seconds.measures = measure_timer.Seconds();
}

}  // namespace

Status FlattenToTargets(const Job& job, Parameterization* result) {
  return Flatten({job.surface, result->targets, job.options, job.control}, &result->certificate,
                 &result->flat);
}

Status LayOutAndMeasure(const Job& job, Parameterization* result) {
  Status status =
      job.options.seams == SeamKind::kFree ? FreeSeams(job, result) : LayOut(job, result);
  if (status.ok()) Measure(job, result);
  return status;
}

bool OpensGivenCut(const Job& job) {
  return job.options.seams != SeamKind::kRigid && job.options.cones.empty() && job.cut &&
         !job.cut->IsEmpty();
}

Status OpenAlongGivenCut(const Job& job, Parameterization* result) {
  const Triangulation& t = job.surface.triangulation;
  const Triangulation open = CutOpen(t, *job.cut);
  const EdgeLengths lengths = OpenedLengths(t, job.surface.lengths, open);
  const IntrinsicSurface surface = MeasureSurface(open, lengths);
  const FileVertices file = NumbersOfOpened(t, job.file, open);
  // Several patches must be disks; one may need to be opened further.
  const Cut none{std::vector<bool>(open.num_edges(), false)};
  const bool several = ConnectedPatches(open).count > 1;
  result->targets = FreeBoundaryTargets(open);
  const Job opened{surface, file, several ? &none : nullptr, job.options, job.control};
  if (several) {
    if (Status s = CheckCut(open, none, {}); !s.ok()) return s;
  }
  if (Status s = FlattenAndLayOut(opened, result); !s.ok()) return s;
  result->cut = Joined(t, *job.cut, open, result->cut);
  Fill(&result->certificate.layout).cut_length = RelativeCutLength(job.surface, result->cut);
  Measure(job, result);
  return Status();
}

}  // namespace cirque

#include "cirque/pipeline/lay_out.h"

#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/solve_summary.h"
#include "cirque/cuts/cut_graph.h"
#include "cirque/layout/planar_layout.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/close_rotations.h"
#include "cirque/pipeline/cut_and_place.h"
#include "cirque/pipeline/cut_costs.h"
#include "cirque/pipeline/exact_layout.h"
#include "cirque/pipeline/finish_layout.h"
#include "cirque/pipeline/flatten.h"
#include "cirque/pipeline/flatten_by_equivalence.h"
#include "cirque/pipeline/make_injective.h"
#include "cirque/pipeline/prescribe_boundary.h"
#include "cirque/pipeline/whole_translations.h"

namespace cirque {
namespace {

using Job = ParameterizeJob;

/// CutAndPlace, timed, with what makes the image injective, the lattice and the exact map where they are
/// asked for.
Status LayOut(const Job& job, Parameterization* result) {
  const Timer timer;
  job.control.BeginStage("layout");
  Status status = CutAndPlace(job, result);
  result->certificate.rotations = MeasureRotations(result->flat);
  if (job.rotations) NoteLoops(job.surface.triangulation, *job.rotations, result);
  AddSeconds(timer, &result->certificate.seconds.layout);
  if (status.ok() && job.options.injective) status = MakeInjective(job, FlattenToTargets, result);
  if (status.ok() && job.options.integer_cells > 0) MoveOntoLattice(job, result);
  if (!status.ok() || !job.options.exact) return status;
  return LayOutExactly(job, result);
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

/// The given cut with what opens further: edges of the surface opened along it.
Cut Joined(const Triangulation& t, const Cut& given, const Triangulation& open,
           const Cut& further) {
  Cut both = given;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (further.edge[open.edge[h]]) both.edge[t.edge[h]] = true;
  }
  return both;
}

/// The points of the surface opened; nothing where there are none.
std::optional<std::vector<Eigen::Vector3d>> PositionsOfOpened(const Job& job,
                                                              const Triangulation& open) {
  if (!job.position) return std::nullopt;
  const Triangulation& t = job.surface.triangulation;
  std::vector<Eigen::Vector3d> position(open.num_vertices);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    position[open.vertex[h]] = (*job.position)[t.vertex[h]];
  }
  return position;
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
  const auto position = PositionsOfOpened(job, open);
  const Job opened{
      surface, job.file, &none, job.options, job.control, nullptr, position ? &*position : nullptr};
  result->targets = FreeBoundaryTargets(open);
  const Status status = FlattenAndLayOut(opened, result);
  LayoutSummary& summary = Fill(&result->certificate.layout);
  summary.cones = static_cast<int>(cones.size());
  if (!status.ok()) return status;
  result->cut = Joined(t, *cut, open, result->cut);
  return Status();
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

/// Flags of edges as flags of the edges of the surface opened.
std::vector<bool> FlagsOfOpened(const Triangulation& t, const std::vector<bool>& flags,
                                const Triangulation& open) {
  std::vector<bool> of_opened(open.num_edges(), false);
  for (Index h = 0; h < t.num_halfedges(); ++h) of_opened[open.edge[h]] = flags[t.edge[h]];
  return of_opened;
}

/// Notes how much of the cut was given.
void NoteGivenCut(const Job& job, Parameterization* result) {
  if (!job.cut || job.cut->IsEmpty()) return;
  const Triangulation& t = job.surface.triangulation;
  LayoutSummary& summary = Fill(&result->certificate.layout);
  summary.given_cut_edges = summary.further_cut_edges = 0;
  for (Index e = 0; e < t.num_edges(); ++e) {
    if (t.IsBoundaryEdge(e) || !result->cut.edge[e]) continue;
    ++*(job.cut->edge[e] ? summary.given_cut_edges : summary.further_cut_edges);
  }
}

/// What is opened before anything is solved: the given cut, or charts, all of them disks.
StatusOr<Cut> FirstCut(const Job& job) {
  if (job.options.least_charts <= 1) return *job.cut;
  return ChooseCut(job, {job.surface.angles, job.surface.lengths, {}}, {});
}

void Measure(const Job& job, Parameterization* result) {
  const Timer measure_timer;
  job.control.BeginStage("measures");
  LayoutSummary& summary = Fill(&result->certificate.layout);
  summary.float32_vanishing_triangles =
      static_cast<int>(FlippedFacesInFloat32(job.surface.triangulation, result->uv).size());
  summary.cut_length = RelativeCutLength(job.surface, result->cut);
  if (job.position && job.measure_visibility) {
    summary.visible_cut_length = VisibleCutLength(job.surface, *job.position, result->cut);
  }
  MeasureDistortion(job.surface.triangulation, job.surface.lengths, result->cut, result->uv,
                    &result->certificate);
  result->certificate.seconds.measures = measure_timer.Seconds();
}

}  // namespace

Status FlattenToTargets(const Job& job, Parameterization* result) {
  const ConeTargets targets = result->targets;
  // Seams of an exact map run along edges of the triangulation that is solved on.
  const bool locks_cut = job.options.exact && job.cut && !job.cut->IsEmpty();
  const FlattenJob flatten = {
      job.surface,   targets, job.options, job.control, locks_cut ? &job.cut->edge : nullptr,
      job.rotations, job.dual};
  const auto by = job.options.pattern == PatternKind::kEquivalence ? FlattenByEquivalence : Flatten;
  if (AsksForBoundary(job.surface, job.options) && HasFreeBoundary(job.surface, targets)) {
    return FlattenWithBoundary(flatten, job.file, by, &result->certificate, &result->targets,
                               &result->flat);
  }
  return by(flatten, &result->certificate, &result->flat);
}

Status LayOutAndMeasure(const Job& job, Parameterization* result) {
  Status status =
      job.options.seams == SeamKind::kFree ? FreeSeams(job, result) : LayOut(job, result);
  if (!status.ok()) return status;
  NoteGivenCut(job, result);
  Measure(job, result);
  return Status();
}

bool OpensFirst(const Job& job) {
  const bool asked = (job.cut && !job.cut->IsEmpty()) || job.options.least_charts > 1;
  return asked && job.options.seams != SeamKind::kRigid && !job.options.AsksForCones() &&
         job.options.holonomy == HolonomyRule::kFree;
}

Status OpenAndLayOut(const Job& job, Parameterization* result) {
  const Triangulation& t = job.surface.triangulation;
  const StatusOr<Cut> cut = FirstCut(job);
  if (!cut.ok()) return cut.status();
  const Triangulation open = CutOpen(t, *cut);
  const EdgeLengths lengths = OpenedLengths(t, job.surface.lengths, open);
  const IntrinsicSurface surface = MeasureSurface(open, lengths);
  const FileVertices file = NumbersOfOpened(t, job.file, open);
  std::vector<bool> inside;
  if (job.inside) inside = FlagsOfOpened(t, *job.inside, open);
  const auto position = PositionsOfOpened(job, open);
  result->targets = FreeBoundaryTargets(open);
  const Job opened{surface,
                   file,
                   nullptr,
                   job.options,
                   job.control,
                   job.inside ? &inside : nullptr,
                   position ? &*position : nullptr};
  if (Status s = FlattenAndLayOut(opened, result); !s.ok()) return s;
  result->cut = Joined(t, *cut, open, result->cut);
  NoteGivenCut(job, result);
  Measure(job, result);
  return Status();
}

}  // namespace cirque

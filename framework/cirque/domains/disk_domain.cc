#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/text.h"
#include "cirque/domains/boundary_spread.h"
#include "cirque/domains/built_in_domains.h"
#include "cirque/domains/disk_map.h"
#include "cirque/domains/disk_placement.h"
#include "cirque/domains/exact_disk.h"
#include "cirque/domains/half_plane_chart.h"
#include "cirque/domains/refine_on_shape.h"
#include "cirque/mesh/split_chords.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/metrics/mapped_faces.h"
#include "cirque/pipeline/finish_layout.h"

namespace cirque {
namespace {

Status CheckDiskOptions(const std::vector<bool>& boundary, const DomainOptions& domain) {
  const std::vector<std::string> known = {"", "none", "boundary", "area"};
  if (std::find(known.begin(), known.end(), domain.normalization) == known.end()) {
    return Status::InvalidInput(
        UnknownName("normalization", domain.normalization, {"none", "boundary", "area"}));
  }
  if (PutsMassAtCentre(domain) && domain.centre != kNone) {
    return Status::InvalidInput("a centre vertex and a normalization exclude each other");
  }
  if (domain.centre != kNone && boundary[domain.centre]) {
    return Status::InvalidInput(fmt::format(
        "vertex {} (0-based) lies on the boundary and cannot be the centre", domain.centre));
  }
  if (domain.angle_zero != kNone && !boundary[domain.angle_zero]) {
    return Status::InvalidInput(
        fmt::format("vertex {} (0-based) is no boundary vertex and cannot lie at angle zero",
                    domain.angle_zero));
  }
  return Status();
}

DiskSummary Summarize(const Surface& surface, const HalfPlaneChart& chart,
                      const DiskPlacement& disk, double spread) {
  DiskSummary summary;
  double circle_error = 0;
  for (const Index v : chart.disk.loop) {
    circle_error = std::max(circle_error, std::abs(std::abs(disk.position()[v]) - 1));
  }
  summary.pole_vertex = FileNumber(surface, chart.disk.pole);
  summary.centre_vertex = FileNumber(surface, disk.centre());
  summary.angle_zero_vertex = FileNumber(surface, disk.angle_zero());
  summary.overhanging_faces = CountFalse(chart.disk.core);
  summary.boundary_spread = spread;
  summary.boundary_straightness = chart.straightness;
  summary.boundary_circle_error = circle_error;
  summary.boundary_centre_of_mass = disk.BoundaryCentreOfMass();
  summary.area_centre_of_mass = disk.AreaCentreOfMass();
  if (disk.centre() != kNone) summary.centre_error = std::abs(disk.position()[disk.centre()]);
  return summary;
}

/// Distortion of what was solved alone: a face with all corners on the circle cannot but be flat.
void MeasureCore(const Surface& surface, const EdgeLengths& lengths, const CornerUv& uv,
                 const std::vector<bool>& core, DiskSummary* summary) {
  const MappedFaces faces = MeasureFaces(surface.triangulation, lengths, uv);
  double sum = 0, area = 0, largest = 1;
  for (Index i = 0; i < faces.num_faces(); ++i) {
    if (!core[faces.face[i]]) continue;
    const double quasi_conformal = faces.sigma_max[i] / faces.sigma_min[i];
    sum += faces.area[i] * quasi_conformal;
    area += faces.area[i];
    largest = std::max(largest, quasi_conformal);
  }
  summary->core_quasi_conformal_mean = sum / area;
  summary->core_quasi_conformal_max = largest;
}

/// The share of spreading that distorts least; 1 where all flip triangles.
double SpreadBest(const IntrinsicSurface& surface, const HalfPlaneChart& chart,
                  DiskPlacement* disk) {
  const auto place = [&](double share, CornerUv* uv) {
    const bool clean = disk->Spread(chart, share).empty();
    *uv = disk->Uv();
    return clean;
  };
  return LeastDistortingShare(surface, place).value_or(1);
}

/// What a refinement leaves where it is: the centre, and the boundary, which slides along the circle
/// but for the vertex of angle zero; all of it where a mean of its places is prescribed.
KeptVertices KeptInDisk(const IntrinsicSurface& surface, const DomainOptions& shape,
                        const DiskPlacement& disk) {
  KeptVertices kept{surface.boundary};
  if (!PutsMassAtCentre(shape)) {
    kept.held.assign(surface.boundary.size(), false);
    kept.sliding.slides = surface.boundary;
    kept.held[disk.angle_zero()] = true;
  }
  if (disk.centre() != kNone) kept.held[disk.centre()] = true;
  return kept;
}

/// Refines the map of the surface, a triangulation of the disk's vertices, inside the circle. Not
/// where the inner vertices' centre of mass is at 0.
Status RefineInDisk(const IntrinsicSurface& surface, const DomainOptions& shape,
                    const std::string& refine_map, const SolveControl& control, DiskPlacement* disk,
                    std::optional<MapRefinementSummary>* summary) {
  if (shape.normalization == "area") return Status();
  CornerUv uv = disk->UvOf(surface.triangulation);
  const Status status = RefineHeldMap(surface, KeptInDisk(surface, shape, *disk), refine_map,
                                      control.cancelled, &uv, summary);
  if (status.ok()) disk->TakePositions(surface.triangulation, uv);
  return status;
}

/// The exact map of what was solved first, placed and refined by itself.
Status MakeExactInDisk(const IntrinsicSurface& surface, const SolvedChart& first,
                       const MapRequest& request, const SolveControl& control, const CutFrom& from,
                       DiskPlacement* disk, SurfaceMap* map) {
  const Timer timer;
  control.BeginStage("exact map");
  const IntrinsicTriangulation whole = FlippedWhole(surface.triangulation, surface.lengths, first);
  const IntrinsicSurface solved = MeasureSurface(whole.triangulation, whole.lengths);
  disk->Place(first.chart);
  if (disk->position().empty()) return DiskUnrepresentable("points of the unit disk");
  if (FlippedFaces(whole.triangulation, disk->UvOf(whole.triangulation)).empty()) {
    std::optional<MapRefinementSummary> unused;
    const std::string refine_map =
        RefinementOnShape(request.options.refine_map, first.layout_closure);
    Status refined = RefineInDisk(solved, request.shape, refine_map, control, disk, &unused);
    if (!refined.ok()) return refined;
  }
  const Status status = DrawExactDisk(surface.triangulation, whole, disk->UvOf(whole.triangulation),
                                      from, request.options.exact_limit, map);
  if (status.ok()) map->certificate.exact_map->exact_layout_closure = first.layout_closure;
  AddSeconds(timer, &map->certificate.seconds.exact);
  return status;
}

/// MapToDisk; faces beyond chords are placed without being solved for. Beside an exact map nothing is
/// spread out: the vertices are where that has them, should their own map flip triangles.
Status SolveDisk(const Surface& surface, const MapRequest& request, const CutFrom& from,
                 const SolveControl& control, SurfaceMap* map) {
  const Triangulation& t = surface.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const IntrinsicSurface intrinsic = MeasureSurface(t, lengths);
  DiskPlacement disk(surface, intrinsic, request.shape, control);
  HalfPlaneChart chart;
  std::optional<SolvedChart> first;
  bool clean = false;
  const Status status = SolveHalfPlaneChart(
      {surface, intrinsic, request.shape.pole, request.options, control},
      [&](const HalfPlaneChart& tried) { return disk.Place(tried); }, &map->certificate, &chart,
      &clean, &first);
  if (!status.ok()) return status;
  double spread = 0;
  if (first) {
    DiskPlacement exact(surface, intrinsic, request.shape, control);
    Status made = MakeExactInDisk(intrinsic, *first, request, control, from, &exact, map);
    if (!made.ok()) return made;
    if (!clean) disk.TakePlaces(exact);
  } else if (!clean) {
    spread = SpreadBest(intrinsic, chart, &disk);
    if (!disk.Spread(chart, spread).empty()) return DiskUnrepresentable("points of the unit disk");
  }
  if (clean || !first) {
    control.BeginStage("refinement");
    const std::string refine_map =
        RefinementOnShape(request.options.refine_map, map->certificate.layout->layout_closure);
    Status refined = RefineInDisk(intrinsic, request.shape, refine_map, control, &disk,
                                  &map->certificate.map_refinement);
    if (!refined.ok()) return refined;
  }
  if (request.options.exact && !first) {
    Status made =
        DrawExactDisk(t, {t, lengths, {}, {}}, disk.Uv(), from, request.options.exact_limit, map);
    if (!made.ok()) return made;
  }
  DiskSummary summary = Summarize(surface, chart, disk, spread);
  DeliverDisk(t, lengths, disk.Uv(), map);
  MeasureCore(surface, lengths, map->uv, chart.disk.core, &summary);
  map->certificate.disk = summary;
  return Status();
}

/// Where the vertices of the first numbers are.
CornerUv PlacesOfOld(const Triangulation& t, const Triangulation& split, const CornerUv& uv) {
  std::vector<Eigen::Vector2d> place(split.num_vertices);
  for (Index h = 0; h < split.num_halfedges(); ++h) place[split.vertex[h]] = uv.value[h];
  CornerUv old;
  for (const Index v : t.vertex) old.value.push_back(place[v]);
  return old;
}

/// What is at 0 and at (1, 0) stays there.
KeptVertices KeptAtMarks(const IntrinsicSurface& surface, const DomainOptions& shape,
                         const CornerUv& uv) {
  KeptVertices kept{surface.boundary};
  if (PutsMassAtCentre(shape)) return kept;
  kept.held.assign(surface.boundary.size(), false);
  kept.sliding.slides = surface.boundary;
  for (std::size_t h = 0; h < uv.value.size(); ++h) {
    const bool mark = uv.value[h] == Eigen::Vector2d(0, 0) || uv.value[h] == Eigen::Vector2d(1, 0);
    if (mark) kept.held[surface.triangulation.vertex[h]] = true;
  }
  return kept;
}

/// Solves for the surface with its chords split, so that what is beyond them is solved for too, and
/// takes the vertices that there were. The status is no proof about the surface.
Status SolveWithChordsSplit(const Surface& surface, const std::vector<bool>& chords,
                            const MapRequest& request, const SolveControl& control,
                            SurfaceMap* map) {
  const Triangulation& t = surface.triangulation;
  const Surface split = SplitEdges(surface, chords);
  const CutFrom from = {FacesBeforeSplit(t, chords), t.num_faces()};
  Status status = SolveDisk(split, request, from, control, map);
  if (!status.ok()) return status;
  if (map->certificate.disk->boundary_spread > 0)
    return DiskUnrepresentable("points of the unit disk");
  if (map->exact_map) {
    StatusOr<ExactMap> exact =
        BeforeSplit(t, chords, split.triangulation, *std::move(map->exact_map));
    if (!exact.ok()) return exact.status();
    map->exact_map = *std::move(exact);
  }
  CornerUv uv = PlacesOfOld(t, split.triangulation, map->uv);
  const bool clean = FlippedFaces(t, uv).empty();
  if (!clean && !map->exact_map) return DiskUnrepresentable("points of the unit disk");
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const IntrinsicSurface intrinsic = MeasureSurface(t, lengths);
  if (clean && request.shape.normalization != "area") {
    const std::string refine_map =
        RefinementOnShape(request.options.refine_map, map->certificate.layout->layout_closure);
    status = RefineHeldMap(intrinsic, KeptAtMarks(intrinsic, request.shape, uv), refine_map,
                           control.cancelled, &uv, &map->certificate.map_refinement);
    if (!status.ok()) return status;
  }
  DiskSummary& summary = *map->certificate.disk;
  summary.split_chords = static_cast<int>(std::count(chords.begin(), chords.end(), true));
  DeliverDisk(t, lengths, std::move(uv), map);
  MeasureCore(surface, lengths, map->uv, LargestChordlessPiece(t, intrinsic.boundary), &summary);
  return Status();
}

}  // namespace

Status MapToDisk(const Surface& surface, const MapRequest& request, const SolveControl& control,
                 SurfaceMap* map) {
  const Triangulation& t = surface.triangulation;
  if (Status s = CheckIsDisk(t); !s.ok()) return s;
  if (Status s = CheckDiskOptions(BoundaryVertices(t), request.shape); !s.ok()) return s;
  const std::vector<bool> chords = ChordsOf(t, BoundaryLoops(t).front());
  if (std::find(chords.begin(), chords.end(), true) != chords.end()) {
    SurfaceMap of_split;
    Status status = SolveWithChordsSplit(surface, chords, request, control, &of_split);
    if (status.ok()) *map = std::move(of_split);
    if (status.ok() || status.code() == StatusCode::kCancelled) return status;
  }
  return SolveDisk(surface, request, {}, control, map);
}

}  // namespace cirque

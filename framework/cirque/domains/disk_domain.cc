#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/count.h"
#include "cirque/core/text.h"
#include "cirque/domains/boundary_spread.h"
#include "cirque/domains/built_in_domains.h"
#include "cirque/domains/disk_placement.h"
#include "cirque/domains/exact_disk.h"
#include "cirque/domains/half_plane_chart.h"
#include "cirque/mesh/split_chords.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/metrics/mapped_faces.h"
#include "cirque/pipeline/finish_layout.h"

namespace cirque {
namespace {

constexpr int kMaxDoublings = 60;  ///< of the pole's height

Index CountFalse(const std::vector<bool>& flags) {
  return static_cast<Index>(std::count(flags.begin(), flags.end(), false));
}

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

Status Unrepresentable(const std::string& what) {
  return Status(StatusCode::kUnrepresentable, "the map exists but " + what +
                                                  " of double coordinates do not tell its vertices "
                                                  "apart; a rectangle or the plane may hold it");
}

Index FileNumber(const Surface& surface, Index v) {
  return v == kNone ? kNone : surface.soup_vertex[v];
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

/// A map whose triangles are not flipped but where an exact one is beside it.
void Deliver(const Triangulation& t, const EdgeLengths& lengths, CornerUv uv, SurfaceMap* map) {
  const Timer timer;
  map->uv = std::move(uv);
  map->cut.edge.assign(t.num_edges(), false);
  const std::size_t flipped = map->exact_map ? FlippedFaces(t, map->uv).size() : 0;
  Fill(&map->certificate.layout).flipped_triangles = static_cast<int>(flipped);
  MeasureDistortion(t, lengths, map->cut, map->uv, &map->certificate);
  map->certificate.seconds.measures = timer.Seconds();
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
Status RefineInDisk(const IntrinsicSurface& surface, const MapRequest& request,
                    const SolveControl& control, DiskPlacement* disk,
                    std::optional<MapRefinementSummary>* summary) {
  if (request.shape.normalization == "area") return Status();
  CornerUv uv = disk->UvOf(surface.triangulation);
  const Status status = RefineHeldMap(surface, KeptInDisk(surface, request.shape, *disk),
                                      request.options.refine_map, control.cancelled, &uv, summary);
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
  if (disk->position().empty()) return Unrepresentable("points of the unit disk");
  if (FlippedFaces(whole.triangulation, disk->UvOf(whole.triangulation)).empty()) {
    std::optional<MapRefinementSummary> unused;
    if (Status s = RefineInDisk(solved, request, control, disk, &unused); !s.ok()) return s;
  }
  const Status status = DrawExactDisk(surface.triangulation, whole, disk->UvOf(whole.triangulation),
                                      from, request.options.exact_limit, map);
  if (status.ok()) map->certificate.exact_map->exact_layout_closure = first.layout_closure;
  AddSeconds(timer, &map->certificate.seconds.exact);
  return status;
}

std::vector<Index> FlippedFrom(const Triangulation& t, const HalfPlaneChart& chart, double height,
                               CornerUv* uv) {
  uv->value.clear();
  for (const Index v : t.vertex) {
    const Complex z = v == chart.disk.pole ? Complex(0.5, height) : chart.position[v];
    uv->value.emplace_back(z.real(), z.imag());
  }
  return FlippedFaces(t, *uv);
}

/// The height of the pole, and the flipped faces that no height avoids.
double RaisePole(const Triangulation& t, const HalfPlaneChart& chart, CornerUv* uv,
                 std::vector<Index>* flipped) {
  double height = 1;
  for (int i = 0; i < kMaxDoublings; ++i, height *= 2) {
    *flipped = FlippedFrom(t, chart, height, uv);
    if (flipped->empty()) break;
  }
  return height;
}

/// A triangle as it is, the side opposite the pole (or the longest one) on the real axis.
CornerUv TriangleInHalfPlane(const Surface& surface, const IntrinsicSurface& triangle, Index pole,
                             SurfaceMap* map) {
  const std::vector<Index>& vertex = triangle.triangulation.vertex;
  Eigen::Index corner = 0;
  triangle.angles.value.maxCoeff(&corner);
  if (pole != kNone) corner = std::find(vertex.begin(), vertex.end(), pole) - vertex.begin();
  const auto at_pole = static_cast<Index>(corner);
  const Index next = Triangulation::Next(at_pole), prev = Triangulation::Prev(at_pole);
  const auto length = [&](Index h) {
    return triangle.lengths.value[triangle.triangulation.edge[h]];
  };
  const double angle = triangle.angles.value[next];
  CornerUv uv{std::vector<Eigen::Vector2d>(3)};
  uv.value[next] = {0, 0};
  uv.value[prev] = {length(at_pole), 0};
  uv.value[at_pole] = length(prev) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  map->certificate.half_plane =
      HalfPlaneSummary{FileNumber(surface, vertex[at_pole]), uv.value[at_pole].y(), 0};
  return uv;
}

/// The map of a surface of but one triangle.
Status DeliverTriangle(const Surface& surface, const IntrinsicSurface& triangle,
                       const MapRequest& request, SurfaceMap* map) {
  const Triangulation& t = surface.triangulation;
  const CornerUv uv = TriangleInHalfPlane(surface, triangle, request.shape.pole, map);
  if (request.options.exact) {
    Status made =
        DrawExactDisk(t, {t, triangle.lengths, {}, {}}, uv, {}, request.options.exact_limit, map);
    if (!made.ok()) return made;
  }
  Deliver(t, triangle.lengths, uv, map);
  return Status();
}

Status CheckNoOverhang(const Surface& surface, const IntrinsicSurface& intrinsic) {
  const std::vector<bool> core = LargestChordlessPiece(surface.triangulation, intrinsic.boundary);
  const Index overhang = CountFalse(core);
  if (overhang == 0) return Status();
  const auto first = std::find(core.begin(), core.end(), false) - core.begin();
  return Status::InvalidInput(fmt::format(
      "{} beyond edges that join two boundary vertices, one of them in face {} "
      "(0-based): a straight boundary leaves them no area; split those edges, or map to the disk",
      Count(overhang, "triangle") + (overhang == 1 ? " lies" : " lie"),
      surface.soup_polygon[first]));
}

/// Refines the chart without the pole's faces: its inner vertices move, those of the straight
/// boundary slide along the real axis, but for the ends of the chain, and the pole's link stays.
/// `t` with `lengths` is a triangulation of the chart's rest.
Status RefineInHalfPlane(const Triangulation& t, const EdgeLengths& lengths,
                         const MapRequest& request, const SolveControl& control,
                         HalfPlaneChart* chart, std::optional<MapRefinementSummary>* summary) {
  const PuncturedDisk& disk = chart->disk;
  if (disk.rest.face.empty()) return Status();
  const IntrinsicSurface rest = MeasureSurface(t, lengths);
  KeptVertices kept{rest.boundary};
  kept.sliding.slides.assign(t.num_vertices, false);
  kept.sliding.direction.assign(t.num_vertices, 1.0);
  for (std::size_t k = 1; k + 1 < disk.chain.size(); ++k) {
    kept.sliding.slides[disk.chain[k]] = true;
    kept.held[disk.chain[k]] = false;
  }
  CornerUv uv;
  for (const Index v : t.vertex) {
    const Complex z = chart->position[disk.rest.vertex[v]];
    uv.value.emplace_back(z.real(), z.imag());
  }
  const Status status = RefineHeldMap(rest, std::move(kept), request.options.refine_map,
                                      control.cancelled, &uv, summary);
  for (Index h = 0; status.ok() && h < t.num_halfedges(); ++h) {
    chart->position[disk.rest.vertex[t.vertex[h]]] = {uv.value[h].x(), uv.value[h].y()};
  }
  return status;
}

/// The same of the exact map of what was solved first, drawn; the height of the pole.
Status MakeExactInHalfPlane(const IntrinsicSurface& surface, const MapRequest& request,
                            const SolveControl& control, SolvedChart* first, double* height,
                            SurfaceMap* map) {
  const Timer timer;
  control.BeginStage("exact map");
  const IntrinsicTriangulation whole = FlippedWhole(surface.triangulation, surface.lengths, *first);
  CornerUv uv;
  std::vector<Index> flipped;
  *height = RaisePole(whole.triangulation, first->chart, &uv, &flipped);
  if (flipped.empty()) {
    std::optional<MapRefinementSummary> unused;
    if (Status s = RefineInHalfPlane(first->rest.triangulation, first->rest.lengths, request,
                                     control, &first->chart, &unused);
        !s.ok()) {
      return s;
    }
    FlippedFrom(whole.triangulation, first->chart, *height, &uv);
  }
  const Status status =
      DrawExactDisk(surface.triangulation, whole, uv, {}, request.options.exact_limit, map);
  if (status.ok()) map->certificate.exact_map->exact_layout_closure = first->layout_closure;
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
    if (!disk.Spread(chart, spread).empty()) return Unrepresentable("points of the unit disk");
  }
  if (clean || !first) {
    control.BeginStage("refinement");
    Status refined =
        RefineInDisk(intrinsic, request, control, &disk, &map->certificate.map_refinement);
    if (!refined.ok()) return refined;
  }
  if (request.options.exact && !first) {
    Status made =
        DrawExactDisk(t, {t, lengths, {}, {}}, disk.Uv(), from, request.options.exact_limit, map);
    if (!made.ok()) return made;
  }
  DiskSummary summary = Summarize(surface, chart, disk, spread);
  Deliver(t, lengths, disk.Uv(), map);
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
  if (map->certificate.disk->boundary_spread > 0) return Unrepresentable("points of the unit disk");
  if (map->exact_map) {
    StatusOr<ExactMap> exact =
        BeforeSplit(t, chords, split.triangulation, *std::move(map->exact_map));
    if (!exact.ok()) return exact.status();
    map->exact_map = *std::move(exact);
  }
  CornerUv uv = PlacesOfOld(t, split.triangulation, map->uv);
  const bool clean = FlippedFaces(t, uv).empty();
  if (!clean && !map->exact_map) return Unrepresentable("points of the unit disk");
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const IntrinsicSurface intrinsic = MeasureSurface(t, lengths);
  if (clean && request.shape.normalization != "area") {
    status = RefineHeldMap(intrinsic, KeptAtMarks(intrinsic, request.shape, uv),
                           request.options.refine_map, control.cancelled, &uv,
                           &map->certificate.map_refinement);
    if (!status.ok()) return status;
  }
  DiskSummary& summary = *map->certificate.disk;
  summary.split_chords = static_cast<int>(std::count(chords.begin(), chords.end(), true));
  Deliver(t, lengths, std::move(uv), map);
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

Status MapToHalfPlane(const Surface& surface, const MapRequest& request,
                      const SolveControl& control, SurfaceMap* map) {
  const Triangulation& t = surface.triangulation;
  if (Status s = CheckIsDisk(t); !s.ok()) return s;
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const IntrinsicSurface intrinsic = MeasureSurface(t, lengths);
  if (t.num_faces() == 1) return DeliverTriangle(surface, intrinsic, request, map);
  if (Status s = CheckNoOverhang(surface, intrinsic); !s.ok()) return s;
  HalfPlaneChart chart;
  std::optional<SolvedChart> first;
  CornerUv uv;
  bool clean = false;
  double height = 1;
  const auto flips = [&](const HalfPlaneChart& tried) {
    std::vector<Index> flipped;
    height = RaisePole(t, tried, &uv, &flipped);
    return flipped;
  };
  const Status status =
      SolveHalfPlaneChart({surface, intrinsic, request.shape.pole, request.options, control}, flips,
                          &map->certificate, &chart, &clean, &first);
  if (!status.ok()) return status;
  if (!clean && !first) return Unrepresentable("points of the half-plane");
  if (first) {
    double exact_height = 1;
    Status made = MakeExactInHalfPlane(intrinsic, request, control, &*first, &exact_height, map);
    if (!made.ok()) return made;
    if (!clean) chart = first->chart, height = exact_height;
  }
  if (clean) {
    control.BeginStage("refinement");
    Status refined = RefineInHalfPlane(chart.disk.rest.triangulation, chart.disk.lengths, request,
                                       control, &chart, &map->certificate.map_refinement);
    if (!refined.ok()) return refined;
  }
  FlippedFrom(t, chart, height, &uv);
  map->certificate.half_plane =
      HalfPlaneSummary{FileNumber(surface, chart.disk.pole), height, chart.straightness};
  Deliver(t, lengths, std::move(uv), map);
  return Status();
}

}  // namespace cirque

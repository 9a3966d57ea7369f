#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/count.h"
#include "cirque/domains/built_in_domains.h"
#include "cirque/domains/disk_map.h"
#include "cirque/domains/exact_disk.h"
#include "cirque/domains/half_plane_chart.h"
#include "cirque/domains/refine_on_shape.h"
#include "cirque/mesh/split_chords.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/finish_layout.h"

namespace cirque {
namespace {

constexpr int kMaxDoublings = 60;  ///< of the pole's height

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
  DeliverDisk(t, triangle.lengths, uv, map);
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
                         const std::string& refine_map, const SolveControl& control,
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
  const Status status =
      RefineHeldMap(rest, std::move(kept), refine_map, control.cancelled, &uv, summary);
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
    const std::string refine_map =
        RefinementOnShape(request.options.refine_map, first->layout_closure);
    if (Status s = RefineInHalfPlane(first->rest.triangulation, first->rest.lengths, refine_map,
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

}  // namespace

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
  if (!clean && !first) return DiskUnrepresentable("points of the half-plane");
  if (first) {
    double exact_height = 1;
    Status made = MakeExactInHalfPlane(intrinsic, request, control, &*first, &exact_height, map);
    if (!made.ok()) return made;
    if (!clean) chart = first->chart, height = exact_height;
  }
  if (clean) {
    control.BeginStage("refinement");
    const std::string refine_map =
        RefinementOnShape(request.options.refine_map, map->certificate.layout->layout_closure);
    Status refined =
        RefineInHalfPlane(chart.disk.rest.triangulation, chart.disk.lengths, refine_map, control,
                          &chart, &map->certificate.map_refinement);
    if (!refined.ok()) return refined;
  }
  FlippedFrom(t, chart, height, &uv);
  map->certificate.half_plane =
      HalfPlaneSummary{FileNumber(surface, chart.disk.pole), height, chart.straightness};
  DeliverDisk(t, lengths, std::move(uv), map);
  return Status();
}

}  // namespace cirque

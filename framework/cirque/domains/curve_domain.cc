#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cirque/core/solve_summary.h"
#include "cirque/domains/built_in_domains.h"
#include "cirque/domains/corner_places.h"
#include "cirque/domains/curve_fit.h"
#include "cirque/domains/curves.h"
#include "cirque/domains/exact_disk.h"
#include "cirque/domains/half_plane_chart.h"
#include "cirque/domains/slide_on_curve.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/layout/landmarks.h"
#include "cirque/layout/stretch_energy.h"
#include "cirque/math/similarity.h"
#include "cirque/mesh/split_chords.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/exact_layout.h"
#include "cirque/pipeline/finish_layout.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;

constexpr char kTooCoarse[] =
    "the map onto the curve exists, but triangles stay straight, and where all corners of one lie "
    "on the boundary the curve must turn outwards between them, which here it does not (split such "
    "triangles, or subdivide the mesh)";

/// The vertices of a boundary, and where on the curve they are to lie.
std::vector<Landmark> LandmarksOf(const ClosedCurve& curve, const VerticesOnCurve& on) {
  std::vector<Landmark> landmarks;
  for (std::size_t k = 0; k < on.vertex.size(); ++k) {
    landmarks.push_back({on.vertex[k], curve.At(on.arcs[k])});
  }
  return landmarks;
}

/// Per vertex of the disk where it is laid out, moved nearest to where the boundary is to lie.
std::vector<Complex> PlacesNear(const std::vector<Landmark>& landmarks, const Triangulation& t,
                                const CornerUv& uv) {
  std::vector<Complex> place = PlacesOfVertices(t, uv), from, to;
  for (const Landmark& landmark : landmarks) {
    from.push_back(place[landmark.vertex]);
    to.emplace_back(landmark.at.x(), landmark.at.y());
  }
  const Similarity similarity = NearestSimilarity(from, to).value_or(Similarity());
  for (Complex& z : place) z = similarity(z);
  return place;
}

/// The same with the boundary on the curve; how far its farthest vertex moved, over the square root of
/// the curve's area.
double PutOnCurve(const std::vector<Landmark>& landmarks, double area,
                  std::vector<Complex>* place) {
  double farthest = 0;
  for (const Landmark& landmark : landmarks) {
    Complex& z = (*place)[landmark.vertex];
    const Complex to(landmark.at.x(), landmark.at.y());
    farthest = std::max(farthest, std::abs(z - to));
    z = to;
  }
  return farthest / std::sqrt(area);
}

/// The places of the surface's corners.
CornerUv UvOf(const Triangulation& t, const std::vector<Complex>& place) {
  CornerUv uv;
  for (const Index v : t.vertex) uv.value.emplace_back(place[v].real(), place[v].imag());
  return uv;
}

/// Bends a map without flipped faces until its boundary lies on the curve, by the distortion of angles.
Status BendOntoCurve(const IntrinsicSurface& surface, const std::vector<Landmark>& landmarks,
                     const SolveControl& control, CornerUv* uv, CurveSummary* summary) {
  RefineStretchOptions options;
  options.weight = 0;
  const Cut none{std::vector<bool>(surface.triangulation.num_edges(), false)};
  const std::vector<Seam> no_seams;
  const StatusOr<LandmarkFit> bent =
      MeetLandmarks({surface, none, no_seams}, *StretchEnergies().Find("area"), options, landmarks,
                    0, control.cancelled, uv);
  if (!bent.ok()) return bent.status();
  summary->bend_steps = bent->steps;
  if (bent->exact) return Status();
  return Status(
      StatusCode::kNotConverged,
      fmt::format(
          "curve: the map could not be bent onto it without flipping triangles; a vertex of the "
          "boundary stays {:.2g} of the image's size away from its place (a triangle with all "
          "corners on the boundary needs a curve that turns outwards between them; a finer "
          "mesh may help, or a curve nearer to the boundary of a map with a free one)",
          bent->miss_after));
}

/// What a map can be bent from: the layout, or where triangles of that are flipped the map to the disk,
/// near the curve. Errors: those of MapToDisk.
Status FindStart(const Surface& surface, const std::vector<Landmark>& landmarks,
                 const MapRequest& request, const SolveControl& control, CornerUv* near) {
  const Triangulation& t = surface.triangulation;
  if (FlippedFaces(t, *near).empty()) return Status();
  MapRequest for_disk;
  for_disk.options = request.options;
  SurfaceMap disk;
  Status status = MapToDisk(surface, for_disk, control, &disk);
  if (status.ok()) *near = UvOf(t, PlacesNear(landmarks, t, disk.uv));
  return status;
}

/// Puts the boundary onto the curve and refines the map.
Status FinishOnCurve(const Surface& surface, const ClosedCurve& curve, VerticesOnCurve on,
                     std::vector<Complex> place, const MapRequest& request,
                     const SolveControl& control, SurfaceMap* map) {
  const Triangulation& t = surface.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const IntrinsicSurface intrinsic = MeasureSurface(t, lengths);
  CurveSummary& summary = *map->certificate.curve;
  const std::vector<Landmark> landmarks = LandmarksOf(curve, on);
  CornerUv near = UvOf(t, place);
  summary.shift = PutOnCurve(landmarks, curve.Area(), &place);
  map->uv = UvOf(t, place);
  if (!FlippedFaces(t, map->uv).empty()) {
    Status bent = FindStart(surface, landmarks, request, control, &near);
    if (bent.code() == StatusCode::kCancelled) return bent;
    if (!bent.ok()) return MeasurePlaced(surface, kTooCoarse, map);
    map->uv = std::move(near);
    bent = BendOntoCurve(intrinsic, landmarks, control, &map->uv, &summary);
    if (!bent.ok()) return bent;
  }
  control.BeginStage("refinement");
  const Status status =
      RefineOnCurve(intrinsic, curve, request.options.refine_map, control.cancelled, &on, &map->uv,
                    &map->certificate.map_refinement);
  return status.ok() ? MeasurePlaced(surface, kTooCoarse, map) : status;
}

Status CheckStart(const Surface& surface, const std::vector<Index>& loop, Index start) {
  const auto starts = [&](Index h) { return surface.triangulation.Tail(h) == start; };
  if (start == kNone || std::any_of(loop.begin(), loop.end(), starts)) return Status();
  return Status::InvalidInput(
      fmt::format("angle_zero: vertex {} (0-based) is no vertex of the boundary, of which it is to "
                  "be the one at the curve's first point",
                  surface.soup_vertex[start]));
}

/// Puts the layout of what was solved onto the curve, for its exact map.
Status PutLayoutOnCurve(const ClosedCurve& curve, VerticesOnCurve on,
                        const ParameterizeOptions& options, const SolveControl& control,
                        SolvedLayout* layout) {
  constexpr char kElsewhere[] = "a finer mesh, or the plane";
  const Triangulation& t = layout->surface.triangulation;
  const std::vector<Landmark> landmarks = LandmarksOf(curve, on);
  std::vector<Complex> place = PlacesNear(landmarks, t, layout->uv);
  CornerUv near = UvOf(t, place);
  PutOnCurve(landmarks, curve.Area(), &place);
  layout->uv = UvOf(t, place);
  if (!FlippedFaces(t, layout->uv).empty() && FlippedFaces(t, near).empty()) {
    layout->uv = std::move(near);
    CurveSummary unused;
    Status bent = BendOntoCurve(layout->surface, landmarks, control, &layout->uv, &unused);
    if (!bent.ok()) return bent.In("the exact map");
  }
  Status status = CheckSolvedNotFlipped(t, layout->uv, kElsewhere);
  if (!status.ok() || !layout->is_circle_pattern) return status;
  std::optional<MapRefinementSummary> unused;
  status = RefineOnCurve(layout->surface, curve, options.refine_map, control.cancelled, &on,
                         &layout->uv, &unused);
  return status.ok() ? CheckSolvedNotFlipped(t, layout->uv, kElsewhere) : status;
}

/// Adds the exact map, of which the boundary is inscribed by itself, from the same vertex on.
Status AddExactMap(const Surface& surface, const Surface& split, const std::vector<bool>& chords,
                   const ClosedCurve& curve, const MapRequest& request, const SolveControl& control,
                   SurfaceMap* map) {
  const Timer timer;
  const Triangulation& t = surface.triangulation;
  SurfaceMap drawn;
  CurveFit fit(split, curve, request, control);
  if (Status s = fit.Run(&drawn); !s.ok()) return s.In("the exact map");
  ParameterizeRequest last = {request.options, fit.targets()};
  last.options.refine_map = "none";
  const std::vector<Index> part_of = FacesBeforeSplit(t, chords);
  last.place_exact = [&](SolvedLayout* layout) {
    layout->part_of = &part_of;
    layout->num_wholes = t.num_faces();
    return PutLayoutOnCurve(curve, fit.on_curve(), request.options, control, layout);
  };
  if (Status s = Parameterize(split, last, control, &drawn); !s.ok()) return s;
  Status status = TakeExactMap(t, chords, split.triangulation, &drawn, map);
  AddSeconds(timer, &map->certificate.seconds.exact);
  return status;
}

}  // namespace

Status MapToCurve(const Surface& surface, const MapRequest& request, const SolveControl& control,
                  SurfaceMap* map) {
  const Triangulation& t = surface.triangulation;
  if (Status s = CheckIsDisk(t); !s.ok()) return s;
  const std::vector<Index> loop = BoundaryLoops(t).front();
  if (Status s = CheckStart(surface, loop, request.shape.angle_zero); !s.ok()) return s;
  const StatusOr<ClosedCurve> curve = CurveOf(request.shape.curve);
  if (!curve.ok()) return curve.status().In("curve");
  const std::vector<bool> chords = ChordsOf(t, loop);
  const bool none = std::find(chords.begin(), chords.end(), true) == chords.end();
  const Surface split = none ? surface : SplitEdges(surface, chords);
  MapRequest at_vertices = request;
  at_vertices.options.exact = false;
  CurveFit fit(split, *curve, at_vertices, control);
  const Status solved = fit.Run(map);
  if (solved.code() == StatusCode::kInfeasible && !none) {
    ForgetProof(map);
    return Status(StatusCode::kNotConverged,
                  "with edges between two vertices of the boundary split, the mesh has no circle "
                  "pattern; subdivide it");
  }
  if (!solved.ok()) return solved;
  map->certificate.curve = fit.summary();
  map->certificate.curve->chords = static_cast<int>(std::count(chords.begin(), chords.end(), true));
  std::vector<Complex> place =
      PlacesNear(LandmarksOf(*curve, fit.on_curve()), split.triangulation, map->uv);
  place.resize(t.num_vertices);
  map->flat = {};
  map->targets = {};
  ForgetCut(t, map);
  if (request.options.exact) {
    MapRequest exact = request;
    exact.shape.angle_zero = fit.on_curve().vertex[0];
    Status made = AddExactMap(surface, split, chords, *curve, exact, control, map);
    if (!made.ok()) return made;
  }
  return FinishOnCurve(surface, *curve, fit.on_curve(), std::move(place), at_vertices, control,
                       map);
}

}  // namespace cirque

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/count.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/text.h"
#include "cirque/domains/boundary_spread.h"
#include "cirque/domains/built_in_domains.h"
#include "cirque/domains/corner_places.h"
#include "cirque/domains/half_plane_chart.h"
#include "cirque/domains/polygon_corners.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/layout/exact_map.h"
#include "cirque/math/moebius.h"
#include "cirque/math/predicates.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/finish_layout.h"

namespace cirque {
namespace {

StatusOr<std::vector<Index>> ChooseCorners(const Surface& surface, const MapRequest& request,
                                           const SolveControl& control, Certificate* certificate) {
  const Triangulation& t = surface.triangulation;
  const std::vector<Index> loop = BoundaryInOrder(t);
  std::vector<Index> corners = request.shape.corners;
  const int sides = request.shape.sides;
  const auto count = corners.empty() ? static_cast<std::size_t>(sides) : corners.size();
  if (count < 3 || count > loop.size()) {
    return Status::InvalidInput(
        fmt::format("a polygon of {}; give 3 or more, at most the {} vertices of the boundary",
                    Count(count, "corner"), loop.size()));
  }
  const std::vector<Index> needed = CornersBeyondChords(t);
  if (corners.empty() && needed.size() >= count) {
    // More needed than there are: these show that in no time.
    corners.assign(needed.begin(), needed.begin() + static_cast<std::ptrdiff_t>(count));
  } else if (corners.empty()) {
    const Timer timer;
    MapRequest for_disk;
    for_disk.options = request.options;
    for_disk.options.refine_map = "none";
    for_disk.options.exact = false;
    SurfaceMap disk;
    const Status status = MapToDisk(surface, for_disk, control, &disk);
    certificate->seconds.corners = timer.Seconds();
    certificate->infeasibility = std::move(disk.certificate.infeasibility);
    if (!status.ok()) return status.In("choosing corners by a map to the disk");
    corners = NearlyRegularCorners(t, disk.uv, sides);
  }
  if (Status s = SortCorners(t, &corners); !s.ok()) return s;
  return corners;
}

/// Straight but at the corners, which have equal angles.
ConeTargets PolygonTargets(const Triangulation& t, const std::vector<Index>& corners) {
  ConeTargets targets = FreeBoundaryTargets(t);
  for (const Index v : BoundaryInOrder(t)) targets.lower[v] = targets.upper[v] = kPi;
  const double angle = kPi * (1 - 2 / static_cast<double>(corners.size()));
  for (const Index v : corners) targets.lower[v] = targets.upper[v] = angle;
  return targets;
}

/// Turns and scales, corner 0 to 0 and corner 1 to 1.
void Align(const std::vector<Index>& corners, std::vector<Complex>* place) {
  const Complex origin = (*place)[corners[0]], side = (*place)[corners[1]] - origin;
  for (Complex& z : *place) z = (z - origin) / side;
}

/// Puts the four sides exactly onto [0, m] x [0, 1]; returns m and by how far opposite sides
/// differed.
std::pair<double, double> SnapToRectangle(const Triangulation& t, const std::vector<Index>& corners,
                                          std::vector<Complex>* place) {
  std::vector<Complex>& z = *place;
  const auto side = [&](int k) { return std::abs(z[corners[(k + 1) % 4]] - z[corners[k]]); };
  const double width = 0.5 * (side(0) + side(2)), height = 0.5 * (side(1) + side(3));
  const double mismatch =
      std::max(std::abs(side(0) - side(2)) / width, std::abs(side(1) - side(3)) / height);
  const double modulus = width / height;
  for (Complex& p : z) p /= height;
  std::vector<Index> loop = BoundaryInOrder(t);
  std::rotate(loop.begin(), std::find(loop.begin(), loop.end(), corners[0]), loop.end());
  int on = -1;  // side
  for (const Index v : loop) {
    const bool is_corner = std::find(corners.begin(), corners.end(), v) != corners.end();
    if (is_corner) ++on;
    Complex& p = z[v];
    if (on == 0 || on == 2) p.imag(on == 0 ? 0 : 1);
    if (on == 1 || on == 3) p.real(on == 1 ? modulus : 0);
    if (is_corner) p = {on == 1 || on == 2 ? modulus : 0.0, on >= 2 ? 1.0 : 0.0};
  }
  return {modulus, mismatch};
}

PolygonSummary Summarize(const Surface& surface, const std::vector<Index>& corners,
                         const std::vector<Complex>& place) {
  PolygonSummary summary;
  summary.shortest_side = std::numeric_limits<double>::infinity();
  summary.longest_side = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const double side = std::abs(place[corners[(k + 1) % corners.size()]] - place[corners[k]]);
    summary.shortest_side = std::min(summary.shortest_side, side);
    summary.longest_side = std::max(summary.longest_side, side);
    summary.corner_vertices.push_back(surface.soup_vertex[corners[k]]);
  }
  return summary;
}

/// Mean of q + 1/q - 2, q the ratio of singular values, from which a map is as good as none.
constexpr double kUseless = 100;

/// The map for these corners; the certificate keeps what it holds of their choice.
Status MapWithCorners(const Surface& surface, const MapRequest& request,
                      const std::vector<Index>& corners, const SolveControl& control,
                      SurfaceMap* map) {
  const std::optional<double> choice_seconds = map->certificate.seconds.corners;
  const ParameterizeRequest straight = {
      request.options, PolygonTargets(surface.triangulation, corners), {}};
  Status status = Parameterize(surface, straight, control, map);
  map->certificate.seconds.corners = choice_seconds;
  return status;
}

/// Boundary vertices spread out along the sides, then refined with the corners held; what a layout
/// would have told of itself is not there.
Status SpreadInstead(const Surface& surface, const MapRequest& request,
                     const std::vector<Index>& corners, const SolveControl& control,
                     SurfaceMap* map) {
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const IntrinsicSurface disk = MeasureSurface(surface.triangulation, lengths);
  const EdgeLengths flat = map->flat.on_input.lengths;
  if (Status s = SpreadInPolygon(disk, flat, corners, &map->uv); !s.ok()) return s;
  control.BeginStage("refinement");
  map->cut.edge.assign(surface.triangulation.num_edges(), false);
  PlanarLayout layout;
  layout.uv = std::move(map->uv);
  const std::vector<Index> no_cones;
  const LaidOutSurface of = {disk, map->flat.on_input, map->cut, no_cones, control.cancelled};
  Status status =
      RefineLayout(of, PolygonTargets(surface.triangulation, corners), request.options.refine_map,
                   &layout, &map->certificate.map_refinement);
  map->uv = std::move(layout.uv);
  map->certificate.layout.emplace().layout_closure = 0;
  const auto& refinement = map->certificate.map_refinement;
  const bool useless = refinement && !(refinement->map_refinement_after < kUseless);
  if (!status.ok() || !useless) return status;
  return Status(StatusCode::kUnrepresentable,
                "doubles hold this surface in a polygon with nothing but useless triangles");
}

/// Puts the vertices where they are wanted; refuses a map that comes out flipped, but beside an exact
/// one.
Status Deliver(const Triangulation& t, const std::vector<Complex>& place, SurfaceMap* map) {
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    map->uv.value[h] = {place[t.vertex[h]].real(), place[t.vertex[h]].imag()};
  }
  const std::vector<Index> flipped = FlippedFaces(t, map->uv);
  LayoutSummary& layout = Fill(&map->certificate.layout);
  layout.flipped_triangles = static_cast<int>(flipped.size());
  layout.float32_vanishing_triangles = static_cast<int>(FlippedFacesInFloat32(t, map->uv).size());
  if (flipped.empty() || map->exact_map) return Status();
  return Status(StatusCode::kUnrepresentable,
                fmt::format("the map exists but doubles cannot hold faces {} (0-based) of it",
                            IdList(flipped, 5)));
}

/// Which polygons have sides to be put onto exactly.
enum class Shape { kPolygon, kRectangle };

/// The exact map where the shape is, by the similarity that takes its own corners there; on the sides
/// of a rectangle lie vertices alone, since edges of the boundary are kept.
Status PutExactInPlace(const Triangulation& t, const std::vector<Index>& corners, Shape shape,
                       ExactMap* exact) {
  std::vector<Complex> place(exact->point.size());
  for (std::size_t c = 0; c < exact->corner.size(); ++c) {
    const Eigen::Vector2d& uv = exact->uv[exact->corner_uv[c]];
    place[exact->corner[c]] = {uv.x(), uv.y()};
  }
  Align(corners, &place);
  if (shape == Shape::kRectangle) SnapToRectangle(t, corners, &place);
  for (std::size_t c = 0; c < exact->corner.size(); ++c) {
    const Complex z = place[exact->corner[c]];
    exact->uv[exact->corner_uv[c]] = {z.real(), z.imag()};
  }
  const auto at = [&](Index c) { return exact->uv[exact->corner_uv[c]]; };
  for (Index c = 0; c < 3 * exact->num_triangles(); c += 3) {
    if (OrientationSign(at(c), at(c + 1), at(c + 2)) > 0) continue;
    return Status(
        StatusCode::kUnrepresentable,
        fmt::format("the exact map has triangles so thin that rounding turns them over on "
                    "the polygon's sides, one of them in face {} (0-based)",
                    exact->face_of_input[c / 3]));
  }
  return Status();
}

/// Puts a map with these corners where its shape is.
Status PutInPlace(const Surface& surface, const std::vector<Index>& corners, Shape shape,
                  SurfaceMap* map) {
  const Triangulation& t = surface.triangulation;
  std::vector<Complex> place = PlacesOfVertices(t, map->uv);
  Align(corners, &place);
  std::optional<std::pair<double, double>> modulus_and_mismatch;
  if (shape == Shape::kRectangle) modulus_and_mismatch = SnapToRectangle(t, corners, &place);
  PolygonSummary summary = Summarize(surface, corners, place);
  if (modulus_and_mismatch) {
    std::tie(summary.conformal_modulus, summary.opposite_side_mismatch) = *modulus_and_mismatch;
  }
  map->certificate.polygon = std::move(summary);
  Status status = Deliver(t, place, map);
  if (!status.ok() || !map->exact_map) return status;
  if (map->certificate.exact_map->exact_origins) {
    return Status(StatusCode::kUnrepresentable,
                  "doubles hold the exact map about several origins only, and a polygon has one");
  }
  return PutExactInPlace(t, corners, shape, &*map->exact_map);
}

Status Map(const Surface& surface, const MapRequest& request, const SolveControl& control,
           Shape shape, SurfaceMap* map) {
  const Triangulation& t = surface.triangulation;
  if (Status s = CheckIsDisk(t); !s.ok()) return s;
  const auto corners = ChooseCorners(surface, request, control, &map->certificate);
  if (!corners.ok()) return corners.status();
  Status status = MapWithCorners(surface, request, *corners, control, map);
  if (status.ok()) status = PutInPlace(surface, *corners, shape, map);
  const bool has_metric = map->flat.on_input.lengths.value.size() == t.num_edges();
  const bool spreads = status.code() == StatusCode::kUnrepresentable && has_metric;
  if (!spreads || !request.spread_boundary || request.options.exact) return status;
  status = SpreadInstead(surface, request, *corners, control, map);
  if (status.ok()) status = PutInPlace(surface, *corners, shape, map);
  if (!status.ok()) return status;
  MeasureDistortion(t, MeasureEdgeLengths(surface), map->cut, map->uv, &map->certificate);
  return status;
}

/// The request with so many corners, or what is wrong with those it names.
StatusOr<MapRequest> WithSides(const MapRequest& request, const char* what, int sides) {
  const auto& corners = request.shape.corners;
  if (!corners.empty() && corners.size() != static_cast<std::size_t>(sides)) {
    return Status::InvalidInput(
        fmt::format("a {} has {} corners, not {}", what, sides, corners.size()));
  }
  MapRequest with_sides = request;
  with_sides.shape.sides = sides;
  return with_sides;
}

/// Boundary vertices that the targets leave free become straight.
Status MapToExteriorAngles(const Surface& surface, const MapRequest& request,
                           const SolveControl& control, SurfaceMap* map) {
  const Triangulation& t = surface.triangulation;
  const ConeTargets free = FreeBoundaryTargets(t);
  ConeTargets straight = *request.targets;
  for (Index v = 0; v < t.num_vertices; ++v) {
    const bool is_free = straight.lower[v] == free.lower[v] && straight.upper[v] == free.upper[v];
    if (free.lower[v] == 0 && is_free) straight.lower[v] = straight.upper[v] = kPi;
  }
  return Parameterize(surface, {request.options, std::move(straight), {}}, control, map);
}

}  // namespace

Status MapToRectangle(const Surface& surface, const MapRequest& request,
                      const SolveControl& control, SurfaceMap* map) {
  const StatusOr<MapRequest> four = WithSides(request, "rectangle", 4);
  return four.ok() ? Map(surface, *four, control, Shape::kRectangle, map) : four.status();
}

Status MapToPolygon(const Surface& surface, const MapRequest& request, const SolveControl& control,
                    SurfaceMap* map) {
  if (request.targets) return MapToExteriorAngles(surface, request, control, map);
  return Map(surface, request, control, Shape::kPolygon, map);
}

Status MapToTriangle(const Surface& surface, const MapRequest& request, const SolveControl& control,
                     SurfaceMap* map) {
  const StatusOr<MapRequest> three = WithSides(request, "triangle", 3);
  return three.ok() ? Map(surface, *three, control, Shape::kPolygon, map) : three.status();
}

Status MapToPlane(const Surface& surface, const MapRequest& request, const SolveControl& control,
                  SurfaceMap* map) {
  return Parameterize(surface, request, control, map);
}

}  // namespace cirque

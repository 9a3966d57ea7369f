#include "cirque/domains/map_mirrored.h"

#include <algorithm>
#include <complex>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cirque/cones/boundaries.h"
#include "cirque/domains/corner_places.h"
#include "cirque/domains/half_plane_chart.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/mesh/mirror_symmetry.h"
#include "cirque/mesh/preflight.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/finish_layout.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;

constexpr double kTolerance = 1e-3;  ///< of the lengths of mirrored edges, relative

constexpr char kFlipped[] =
    "both halves of the map exist, but put together triangles are flipped: of polygons (filled "
    "holes "
    "too) that are cut into triangles otherwise than their mirror images, or by rounding";

Status CheckRequest(const MapRequest& request) {
  const ParameterizeOptions& options = request.options;
  const char* what = request.targets                           ? "prescribed angle sums"
                     : request.rotations                       ? "rotations along loops"
                     : request.cut                             ? "cut of your own"
                     : options.AsksForCones()                  ? "cones"
                     : options.exact                           ? "exact map"
                     : options.injective                       ? "injective map"
                     : options.boundary != kFreeBoundary       ? "boundary shape"
                     : options.holonomy != HolonomyRule::kFree ? "holonomy"
                     : options.least_charts > 0                ? "least_charts"
                     : options.solve_at > 0                    ? "solve_at"
                     : !request.shape.pins.empty()             ? "pins"
                                                               : nullptr;
  if (!what) return Status();
  return Status::InvalidInput(fmt::format(
      "symmetric maps one half of the surface, and takes no {}; leave out one of both", what));
}

/// A polygon whose corners are points: vertices of the surface, and behind them the middles of edges that
/// lead across the axis.
using Piece = std::vector<Index>;

/// One half of a disk that is its own mirror image, polygons across the axis halved.
class MirroredHalf {
 public:
  MirroredHalf(const Surface& surface, const PolygonRings& rings, MirrorSymmetry symmetry)
      : surface_(surface),
        t_(surface.triangulation),
        rings_(rings),
        symmetry_(std::move(symmetry)) {
    FindAxis();
    Take(PiecesOfOneSide(CutPolygons()));
  }

  /// Errors: those of Preflight, for a half that is no surface.
  StatusOr<Surface> MakeSurface() const {
    PreflightReport report;
    return Preflight(soup_, &report);
  }

  /// Free but along the axis, which is straight.
  ConeTargets TargetsOf(const Surface& half) const {
    ConeTargets targets = FreeBoundaryTargets(half.triangulation);
    for (Index v = 0; v < half.triangulation.num_vertices; ++v) {
      if (IsOnAxis(half, v) && !on_rim_[PointOf(half, v)])
        targets.lower[v] = targets.upper[v] = kPi;
    }
    return targets;
  }

  /// Turns a map of the half so that its axis is x = 0, exactly, and the half at x < 0.
  void PutUpright(const Surface& half, CornerUv* uv) const {
    const Triangulation& t = half.triangulation;
    // The half lies to the left of its boundary, which leaves the axis at its end.
    Complex begin = 0, end = 0;
    for (Index h = 0; h < t.num_halfedges(); ++h) {
      const bool from_axis = IsOnAxis(half, t.Tail(h));
      if (t.twin[h] != kNone || from_axis == IsOnAxis(half, t.Tip(h))) continue;
      const Eigen::Vector2d& p = uv->value[from_axis ? t.Next(h) : t.Prev(h)];
      (from_axis ? end : begin) = {p.x(), p.y()};
    }
    const Complex turn = Complex(0, 1) * std::conj(end - begin) / std::abs(end - begin);
    for (Index h = 0; h < t.num_halfedges(); ++h) {
      const Complex z = turn * (Complex(uv->value[h].x(), uv->value[h].y()) - begin);
      uv->value[h] = {IsOnAxis(half, t.vertex[h]) ? 0 : z.real(), z.imag()};
    }
  }

  /// The axis: its vertices slide along it but where it meets the boundary, where they stay.
  KeptVertices Kept(const Surface& half) const {
    KeptVertices kept;
    const Index n = half.triangulation.num_vertices;
    kept.sliding.direction.assign(n, Complex(0, 1));
    for (Index v = 0; v < n; ++v) {
      const bool at_end = on_rim_[PointOf(half, v)];
      kept.held.push_back(IsOnAxis(half, v) && at_end);
      kept.sliding.slides.push_back(IsOnAxis(half, v) && !at_end);
    }
    return kept;
  }

  /// The places of the surface's corners: those of the half and of their mirror images.
  std::vector<Complex> Places(const Surface& half, const CornerUv& uv) const {
    const Triangulation& t = half.triangulation;
    std::vector<Complex> of_half(on_axis_.size());
    std::vector<bool> has_place(on_axis_.size(), false);
    for (Index h = 0; h < t.num_halfedges(); ++h) {
      const Index p = PointOf(half, t.vertex[h]);
      of_half[p] = {uv.value[h].x(), uv.value[h].y()};
      has_place[p] = true;
    }
    std::vector<Complex> place;
    for (const Index v : t_.vertex) {
      place.push_back(has_place[v] ? of_half[v] : -std::conj(of_half[symmetry_.vertex[v]]));
    }
    return place;
  }

  MirrorSummary Summary() const {
    MirrorSummary summary;
    const auto end = on_axis_.begin() + t_.num_vertices;
    summary.on_axis = static_cast<Index>(std::count(on_axis_.begin(), end, true));
    summary.across_axis = static_cast<Index>(on_axis_.end() - end);
    summary.length_mismatch = symmetry_.length_mismatch;
    return summary;
  }

 private:
  Index PointOf(const Surface& half, Index v) const { return point_[half.soup_vertex[v]]; }

  bool IsOnAxis(const Surface& half, Index v) const { return on_axis_[PointOf(half, v)]; }

  /// Vertices that are their own image, and middles of edges that are theirs the other way round.
  void FindAxis() {
    on_rim_ = BoundaryVertices(t_);
    for (Index v = 0; v < t_.num_vertices; ++v) on_axis_.push_back(symmetry_.vertex[v] == v);
    middle_.assign(t_.num_edges(), kNone);
    for (Index e = 0; e < t_.num_edges(); ++e) {
      const Index h = t_.edge_halfedge[e];
      if (symmetry_.halfedge[h] != h) continue;
      middle_[e] = static_cast<Index>(on_axis_.size());
      across_.push_back(e);
      on_axis_.push_back(true);
      on_rim_.push_back(t_.IsBoundaryEdge(e));
    }
  }

  Eigen::Vector3d PositionOf(Index point) const {
    if (point < t_.num_vertices) return surface_.position[point];
    const Index h = t_.edge_halfedge[across_[point - t_.num_vertices]];
    return surface_.position[t_.Tail(h)] +
           0.5 * (surface_.position[t_.Tip(h)] - surface_.position[t_.Tail(h)]);
  }

  /// Polygons, those that are their own image in two: at their two points on the axis.
  std::vector<Piece> CutPolygons() const {
    std::vector<Piece> pieces;
    std::vector<bool> done(t_.num_halfedges(), false);
    for (Index first = 0; first < t_.num_halfedges(); ++first) {
      if (!rings_.HasEdge(first) || done[first]) continue;
      Piece ring;
      bool is_own_image = false;
      Index h = first;
      do {
        done[h] = true;
        is_own_image |= symmetry_.halfedge[h] == first;
        ring.push_back(t_.Tail(h));
        if (middle_[t_.edge[h]] != kNone) ring.push_back(middle_[t_.edge[h]]);
        h = rings_.next[h];
      } while (h != first);
      is_own_image ? CutAlongAxis(std::move(ring), &pieces) : pieces.push_back(std::move(ring));
    }
    return pieces;
  }

  void CutAlongAxis(Piece ring, std::vector<Piece>* pieces) const {
    const auto is_on_axis = [&](Index point) { return on_axis_[point]; };
    std::rotate(ring.begin(), std::find_if(ring.begin(), ring.end(), is_on_axis), ring.end());
    const auto second = std::find_if(ring.begin() + 1, ring.end(), is_on_axis);
    pieces->emplace_back(ring.begin(), second == ring.end() ? second : second + 1);
    if (second == ring.end()) return;
    pieces->emplace_back(second, ring.end());
    pieces->back().push_back(ring.front());
  }

  /// The pieces that lie on the first one's side: joined to it by other edges than the axis'.
  std::vector<Piece> PiecesOfOneSide(const std::vector<Piece>& pieces) const {
    std::map<std::pair<Index, Index>, std::size_t> of_side;
    const auto for_each_side = [](const Piece& piece, const auto& visit) {
      for (std::size_t k = 0; k < piece.size(); ++k) {
        visit(piece[k], piece[(k + 1) % piece.size()]);
      }
    };
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      for_each_side(pieces[i], [&](Index a, Index b) { of_side[{a, b}] = i; });
    }
    std::vector<bool> taken(pieces.size(), false);
    std::vector<std::size_t> open = {0};
    std::vector<Piece> side;
    taken[0] = true;
    while (!open.empty()) {
      side.push_back(pieces[open.back()]);
      open.pop_back();
      for_each_side(side.back(), [&](Index a, Index b) {
        const auto across = of_side.find({b, a});
        if ((on_axis_[a] && on_axis_[b]) || across == of_side.end() || taken[across->second])
          return;
        taken[across->second] = true;
        open.push_back(across->second);
      });
    }
    return side;
  }

  void Take(const std::vector<Piece>& pieces) {
    std::vector<Index> number(on_axis_.size(), kNone);
    for (const Piece& piece : pieces) {
      for (const Index point : piece) {
        if (number[point] == kNone) {
          number[point] = static_cast<Index>(point_.size());
          point_.push_back(point);
          soup_.position.push_back(PositionOf(point));
        }
        soup_.corner.push_back(number[point]);
      }
      soup_.first_corner.push_back(static_cast<Index>(soup_.corner.size()));
    }
  }

  const Surface& surface_;
  const Triangulation& t_;
  const PolygonRings& rings_;
  const MirrorSymmetry symmetry_;
  std::vector<Index> middle_;           ///< per edge: its middle, where it leads across the axis
  std::vector<Index> across_;           ///< those edges
  std::vector<bool> on_axis_, on_rim_;  ///< of points
  std::vector<Index> point_;            ///< of the soup's vertices
  PolygonSoup soup_;
};

}  // namespace

Status MapMirrored(const Surface& surface, const MapRequest& request, const SolveControl& control,
                   SurfaceMap* map) {
  const Triangulation& t = surface.triangulation;
  if (Status s = CheckRequest(request); !s.ok()) return s;
  if (Status s = CheckIsDisk(t); !s.ok()) return s.In("symmetric");
  const PolygonRings rings = RingsOf(surface);
  std::optional<MirrorSymmetry> symmetry = FindMirrorSymmetry(surface, rings, kTolerance);
  if (!symmetry) {
    return Status::InvalidInput(fmt::format(
        "symmetric: no mirror image of the mesh is the mesh itself, edges of equal "
        "lengths (within {:g} of them) on one another; leave out symmetric, or mesh both "
        "halves alike",
        kTolerance));
  }
  const MirroredHalf halved(surface, rings, *std::move(symmetry));
  const StatusOr<Surface> half = halved.MakeSurface();
  if (!half.ok()) return half.status().In("symmetric: the half");
  ParameterizeOptions options = request.options;
  options.refine_map = "none";
  Status status = Parameterize(*half, {options, halved.TargetsOf(*half), {}, {}}, control, map);
  map->certificate.mirror = halved.Summary();
  if (!status.ok()) {
    ForgetProof(map);
    const bool infeasible = status.code() == StatusCode::kInfeasible;
    return Status(infeasible ? StatusCode::kNotConverged : status.code(), status.message())
        .In("symmetric: the half");
  }
  halved.PutUpright(*half, &map->uv);
  control.BeginStage("refinement");
  const EdgeLengths lengths = MeasureEdgeLengths(*half);
  if (FlippedFaces(half->triangulation, map->uv).empty()) {
    status = RefineHeldMap(MeasureSurface(half->triangulation, lengths), halved.Kept(*half),
                           request.options.refine_map, control.cancelled, &map->uv,
                           &map->certificate.map_refinement);
    if (!status.ok()) return status;
  }
  const std::vector<Complex> places = halved.Places(*half, map->uv);
  map->flat = {};
  map->targets = FreeBoundaryTargets(t);
  ForgetCut(t, map);
  return PutCorners(surface, places, kFlipped, map);
}

}  // namespace cirque

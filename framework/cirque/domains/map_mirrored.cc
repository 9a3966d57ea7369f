#include "cirque/domains/map_mirrored.h"

#include <algorithm>
#include <complex>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cirque/cones/boundaries.h"
#include "cirque/domains/corner_places.h"
#include "cirque/domains/half_plane_chart.h"
#include "cirque/mesh/mirror_symmetry.h"
#include "cirque/mesh/preflight.h"
#include "cirque/mesh/split_chords.h"
#include "cirque/pipeline/finish_layout.h"

namespace cirque {
namespace {

constexpr double kTolerance = 1e-3;  ///< of the lengths of mirrored edges, relative

constexpr char kFlipped[] =
    "the two halves of the map exist, but doubles do not hold them side by side";

Status CheckRequest(const MapRequest& request) {
  const ParameterizeOptions& options = request.options;
  const char* what = request.targets                           ? "prescribed angle sums"
                     : request.cut                             ? "cut of your own"
                     : options.AsksForCones()                  ? "cones"
                     : options.exact                           ? "exact map"
                     : options.injective                       ? "injective map"
                     : options.boundary != kFreeBoundary       ? "boundary shape"
                     : options.holonomy != HolonomyRule::kFree ? "holonomy"
                     : options.solve_at > 0                    ? "solve_at"
                     : !request.shape.pins.empty()             ? "pins"
                                                               : nullptr;
  if (!what) return Status();
  return Status::InvalidInput(fmt::format(
      "symmetric maps one half of the surface, and takes no {}; leave out one of both", what));
}

/// One half of a disk that is its own mirror image.
class MirroredHalf {
 public:
  MirroredHalf(const Surface& surface, MirrorSymmetry symmetry)
      : surface_(surface), symmetry_(std::move(symmetry)), split_(SplitAcrossAxis()) {
    const Triangulation& t = split_.triangulation;
    on_axis_.assign(t.num_vertices, true);  // the middles of edges across it
    for (Index v = 0; v < surface.triangulation.num_vertices; ++v) {
      on_axis_[v] = symmetry_.vertex[v] == v;
    }
    Cut axis{std::vector<bool>(t.num_edges(), false)};
    for (Index e = 0; e < t.num_edges(); ++e) {
      const Index h = t.edge_halfedge[e];
      axis.edge[e] = on_axis_[t.Tail(h)] && on_axis_[t.Tip(h)];
    }
    Take(ConnectedPatches(CutOpen(t, axis)));
  }

  /// Errors: those of Preflight, for a half that is no surface.
  StatusOr<Surface> MakeSurface() const {
    PreflightReport report;
    return Preflight(soup_, &report);
  }

  /// Free but along the axis, which is straight.
  ConeTargets TargetsOf(const Surface& half) const {
    ConeTargets targets = FreeBoundaryTargets(half.triangulation);
    const std::vector<bool> rim = BoundaryVertices(split_.triangulation);
    for (Index v = 0; v < half.triangulation.num_vertices; ++v) {
      const Index whole = vertex_[half.soup_vertex[v]];
      if (on_axis_[whole] && !rim[whole]) targets.lower[v] = targets.upper[v] = kPi;
    }
    return targets;
  }

  /// The places of the surface's corners: the half's, turned so that its axis is x = 0, and those of
  /// their mirror images.
  std::vector<std::complex<double>> Places(const Surface& half, const CornerUv& uv) const {
    std::vector<std::complex<double>> of_half(split_.triangulation.num_vertices);
    std::vector<bool> has_place(of_half.size(), false);
    for (Index h = 0; h < half.triangulation.num_halfedges(); ++h) {
      const Index v = vertex_[half.soup_vertex[half.triangulation.vertex[h]]];
      of_half[v] = {uv.value[h].x(), uv.value[h].y()};
      has_place[v] = true;
    }
    const auto [begin, end] = EndsOfAxis();
    const std::complex<double> origin = of_half[begin], along = of_half[end] - origin;
    const std::complex<double> turn =
        std::complex<double>(0, 1) * std::conj(along) / std::abs(along);
    for (std::size_t v = 0; v < of_half.size(); ++v) {
      of_half[v] = turn * (of_half[v] - origin);
      if (on_axis_[v]) of_half[v].real(0);
    }
    std::vector<std::complex<double>> place;
    for (const Index v : surface_.triangulation.vertex) {
      place.push_back(has_place[v] ? of_half[v] : -std::conj(of_half[symmetry_.vertex[v]]));
    }
    return place;
  }

  MirrorSummary Summary() const {
    MirrorSummary summary;
    summary.on_axis = static_cast<Index>(
        std::count(on_axis_.begin(), on_axis_.begin() + surface_.triangulation.num_vertices, true));
    summary.across_axis = split_.triangulation.num_vertices - surface_.triangulation.num_vertices;
    summary.length_mismatch = symmetry_.length_mismatch;
    return summary;
  }

 private:
  /// Edges that are their own image the other way round are halved, and the faces at them.
  Surface SplitAcrossAxis() const {
    const Triangulation& t = surface_.triangulation;
    std::vector<bool> across(t.num_edges(), false);
    bool any = false;
    for (Index h = 0; h < t.num_halfedges(); ++h) {
      if (symmetry_.corner[h] == h) any = across[t.edge[h]] = true;
    }
    return any ? SplitEdges(surface_, across) : surface_;
  }

  /// The faces on the side of the first one.
  void Take(const Patches& sides) {
    const Triangulation& t = split_.triangulation;
    std::vector<Index> number(t.num_vertices, kNone);
    for (Index f = 0; f < t.num_faces(); ++f) {
      if (sides.of_face[f] != 0) continue;
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        const Index v = t.vertex[h];
        if (number[v] == kNone) {
          number[v] = static_cast<Index>(vertex_.size());
          vertex_.push_back(v);
          soup_.position.push_back(split_.position[v]);
        }
        soup_.corner.push_back(number[v]);
      }
      soup_.first_corner.push_back(static_cast<Index>(soup_.corner.size()));
    }
  }

  /// Where the axis meets the boundary, so that the half lies to the left of the way from one to the
  /// other, which goes to x = 0 upwards.
  std::pair<Index, Index> EndsOfAxis() const {
    const Triangulation& t = split_.triangulation;
    std::vector<bool> in_half(t.num_vertices, false);
    for (const Index v : vertex_) in_half[v] = true;
    Index begin = kNone, end = kNone;
    for (Index h = 0; h < t.num_halfedges(); ++h) {
      if (t.twin[h] != kNone || !in_half[t.Tail(h)] || !in_half[t.Tip(h)]) continue;
      // The half's own boundary leaves the axis at its end, and comes back to its beginning.
      if (on_axis_[t.Tail(h)]) end = t.Tail(h);
      if (on_axis_[t.Tip(h)]) begin = t.Tip(h);
    }
    return {begin, end};
  }

  const Surface& surface_;
  const MirrorSymmetry symmetry_;
  const Surface split_;
  std::vector<bool> on_axis_;  ///< of split_'s vertices
  std::vector<Index> vertex_;  ///< of the soup's vertices: that of split_
  PolygonSoup soup_;
};

}  // namespace

Status MapMirrored(const Surface& surface, const MapRequest& request, const SolveControl& control,
                   SurfaceMap* map) {
  const Triangulation& t = surface.triangulation;
  if (Status s = CheckRequest(request); !s.ok()) return s;
  if (Status s = CheckIsDisk(t); !s.ok()) return s.In("symmetric");
  std::optional<MirrorSymmetry> symmetry =
      FindMirrorSymmetry(t, MeasureEdgeLengths(surface), kTolerance);
  if (!symmetry) {
    return Status::InvalidInput(fmt::format(
        "symmetric: no mirror image of the mesh is the mesh itself, edges of equal "
        "lengths (within {:g} of them) on one another; leave out symmetric, or mesh both "
        "halves alike",
        kTolerance));
  }
  const MirroredHalf halved(surface, *std::move(symmetry));
  const StatusOr<Surface> half = halved.MakeSurface();
  if (!half.ok()) return half.status().In("symmetric: the half");
  Status status =
      Parameterize(*half, {request.options, halved.TargetsOf(*half), {}, {}}, control, map);
  map->certificate.mirror = halved.Summary();
  if (!status.ok()) {
    map->certificate.infeasibility = {};
    map->flat.infeasibility = {};
    const bool infeasible = status.code() == StatusCode::kInfeasible;
    return Status(infeasible ? StatusCode::kNotConverged : status.code(), status.message())
        .In("symmetric: the half");
  }
  const auto places = halved.Places(*half, map->uv);
  map->flat = {};
  map->targets = FreeBoundaryTargets(t);
  ForgetCut(t, map);
  return PutCorners(surface, places, kFlipped, map);
}

}  // namespace cirque

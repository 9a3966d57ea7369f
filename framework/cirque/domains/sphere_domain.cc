#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/count.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/text.h"
#include "cirque/domains/built_in_domains.h"
#include "cirque/domains/exact_sphere.h"
#include "cirque/domains/sphere_normalization.h"
#include "cirque/domains/sphere_placement.h"
#include "cirque/domains/sphere_pole.h"
#include "cirque/layout/linear_layout.h"
#include "cirque/layout/planar_layout.h"
#include "cirque/pipeline/flatten.h"

namespace cirque {
namespace {

constexpr char kDefaultNormalization[] = "surface_area";
constexpr Index kMaxPoles = 4;
constexpr double kLeastLinkMargin = 1e-8;  ///< [rad]: as far down as FitAngles goes with epsilon
/// Circles on one sphere that doubles tell from points have log radii over a range of 36; their
/// stereographic images, where small ones may lie far out, over twice that.
constexpr double kGreatestLogRadiusRange = 72;
/// A prediction by the linear model that is so many times as much is never wrong about that.
constexpr double kSurely = 3;

Status CheckNormalization(const std::string& name) {
  const std::vector<std::string>& known = SphereNormalizations();
  if (std::find(known.begin(), known.end(), name) != known.end()) return Status();
  return Status::InvalidInput(UnknownName("normalization", name, known));
}

Status CheckSurface(const Surface& surface) {
  const Triangulation& t = surface.triangulation;
  const std::size_t loops = BoundaryLoops(t).size();
  if (loops > 0) {
    return Status::InvalidInput(fmt::format(
        "a map to the sphere needs a closed surface, but this has boundary loops: {}; close them",
        loops));
  }
  const Index genus = 1 - EulerCharacteristic(t) / 2;
  if (genus != 0) {
    return Status::InvalidInput(fmt::format(
        "a map to the sphere needs a surface of genus 0, but this has genus {}", genus));
  }
  return Status();
}

/// Interior vertices flat; the link free but convex by a margin.
ConeTargets ConvexLinkTargets(const IntrinsicSurface& plane, double margin) {
  ConeTargets targets = FreeBoundaryTargets(plane.triangulation);
  for (Index v = 0; v < plane.triangulation.num_vertices; ++v) {
    if (plane.boundary[v]) targets.upper[v] = kPi - margin;
  }
  return targets;
}

StatusOr<PlanarLayout> LayOutBy(LayoutMethod method, const Triangulation& disk,
                                const InputChart& flat) {
  const Cut no_cut = {std::vector<bool>(disk.num_edges(), false)};
  if (method == LayoutMethod::kDirections)
    return LayOutPatches(disk, flat.angles, flat.lengths, no_cut);
  return LayOutByLeastSquares(disk, flat.angles, flat.lengths, no_cut);
}

/// What `step` returns, its time added to the stage's.
template <class Step>
auto Timed(std::optional<double>* seconds, const Step& step) {
  const Timer timer;
  auto result = step();
  AddSeconds(timer, seconds);
  return result;
}

/// One surface on its way to the sphere.
class SphereMapping {
 public:
  SphereMapping(const Surface& surface, const EdgeLengths& lengths, const DomainOptions& options,
                const ParameterizeOptions& parameterize_options, const SolveControl& control,
                SurfaceMap* map)
      : surface_(surface),
        t_(surface.triangulation),
        lengths_(lengths),
        options_(options),
        in_plane_(parameterize_options),
        control_(control),
        map_(*map),
        seconds_(map->certificate.seconds),
        summary_(Fill(&map->certificate.sphere)),
        placement_(surface, lengths, options, in_plane_.refine_map, control, map) {
    in_plane_.triangulation =
        SolvedTriangulation::kInput;  // flips are made here, on the closed surface
    in_plane_.exact = false;          // likewise
    wants_exact_ = parameterize_options.exact;
    flips_ = parameterize_options.triangulation != SolvedTriangulation::kInput;
  }

  Status Run() {
    IntrinsicTriangulation delaunay = {t_, lengths_, {}, {}};
    if (flips_) delaunay = Timed(&seconds_.triangulation, [&] { return Delaunay({}); });
    std::vector<Index> poles = {options_.pole};
    if (options_.pole == kNone) {
      poles = Timed(&seconds_.pole, [&] { return PoleCandidates(surface_, delaunay, kMaxPoles); });
    }
    if (const Status s = CheckPrediction(delaunay, poles); !s.ok()) return s;
    Status status = Status::InvalidInput("no vertex is the centre of a disk of triangles");
    for (std::size_t i = 0; i < poles.size(); ++i) {
      summary_.pole_attempts = static_cast<int>(i + 1);
      status = TryPole(poles[i], delaunay);
      const bool may_do_better = status.code() == StatusCode::kNotConverged ||
                                 status.code() == StatusCode::kUnrepresentable;
      if (!may_do_better || !placement_.is_normalized() || IsBeyondDoubles()) break;
    }
    if (!status.ok()) map_.position.clear();
    return status;
  }

 private:
  IntrinsicTriangulation Delaunay(const std::vector<bool>& locked) const {
    return MakeIntrinsicDelaunay(t_, lengths_, {nullptr, locked});
  }

  /// What no solve need find out: limbs too long for doubles.
  Status CheckPrediction(const IntrinsicTriangulation& delaunay, const std::vector<Index>& poles) {
    if (poles.empty()) return Status();
    log_radius_range_ = PredictedLogRange(delaunay, poles.front());
    if (log_radius_range_ > kSurely * kGreatestLogRadiusRange) return BeyondDoubles();
    log_radius_range_ = 0;
    return Status();
  }

  Status TryPole(Index pole, const IntrinsicTriangulation& delaunay) {
    pole_ = pole;
    summary_.pole_vertex = surface_.soup_vertex[pole];
    map_.exact_map.reset();
    first_ = {};
    const Status status = TryPoleAtVertices(delaunay);
    const bool beside = status.code() != StatusCode::kCancelled && map_.exact_map;
    return status.ok() || !beside ? status : TakeExactPlaces();
  }

  /// The vertices where the exact map has them, though their own map flips triangles or there is none;
  /// what the certificate says of the solve is the first one's.
  Status TakeExactPlaces() {
    map_.position = PlacesOfVertices(*map_.exact_map, t_.num_vertices);
    summary_ = *first_.sphere;
    map_.certificate.angle_fit = first_.angle_fit;
    map_.certificate.radii = first_.radii;
    map_.certificate.triangulation = first_.triangulation;
    map_.certificate.map_refinement.reset();
    map_.certificate.infeasibility = {};
    placement_.FindFlipped();
    return Status();
  }

  Status TryPoleAtVertices(const IntrinsicTriangulation& delaunay) {
    if (flips_) {
      const auto flipped = TryLockingFlipped(delaunay);
      if (flipped.ok() && flipped->empty()) return Status();
      const Status& status = flipped.status();
      const bool final = status.code() == StatusCode::kCancelled || !placement_.is_normalized();
      if (final || IsBeyondDoubles()) return status;
    }
    const Status status = TryOn({t_, lengths_, {}, {}});
    if (!status.ok() || placement_.flipped().empty()) return status;
    return Unrepresentable();
  }

  /// The flipped faces of the last round, or its error.
  StatusOr<std::vector<Index>> TryLockingFlipped(const IntrinsicTriangulation& delaunay) {
    int rounds = 0;
    const auto solve = [&](const std::vector<bool>& locked) -> StatusOr<std::vector<Index>> {
      Fill(&map_.certificate.triangulation).delaunay_rounds = ++rounds;
      const Status status =
          rounds == 1 ? TryOn(delaunay)
                      : TryOn(Timed(&seconds_.triangulation, [&] { return Delaunay(locked); }));
      return status.ok() ? StatusOr<std::vector<Index>>(placement_.flipped()) : status;
    };
    return SolveLockingFlipped(std::vector<bool>(t_.num_edges(), false), solve,
                               [&](const std::vector<Index>& faces, std::vector<bool>* locked) {
                                 for (const Index f : faces) {
                                   for (Index h = 3 * f; h < 3 * f + 3; ++h) {
                                     (*locked)[t_.edge[h]] = true;
                                   }
                                 }
                                 return true;
                               });
  }

  Status TryOn(const IntrinsicTriangulation& intrinsic) {
    const StatusOr<PuncturedSurface> punctured = Puncture(intrinsic.triangulation, pole_);
    if (!punctured.ok()) return punctured.status();
    const EdgeLengths lengths = ReferenceLengths(intrinsic, *punctured);
    const IntrinsicSurface plane = MeasureSurface(punctured->triangulation, lengths);
    FlatSurface flat;
    const Status status = FlattenWithConvexLink(plane, &flat);
    Fill(&map_.certificate.triangulation).flips = static_cast<int>(intrinsic.flips.size());
    summary_.pole_corners = static_cast<int>(punctured->link.size());
    if (!flat.infeasibility.empty()) NumberAsInFile(surface_, *punctured, &flat.infeasibility);
    map_.certificate.infeasibility = std::move(flat.infeasibility);
    if (map_.certificate.radii) log_radius_range_ = map_.certificate.radii->log_radius_range;
    if (IsBeyondDoubles()) return BeyondDoubles();
    if (!status.ok()) return status;
    summary_.delaunay_margin = SphericalDelaunayMargin(plane, flat.on_input.angles.value);
    PlaneWithPole layout;
    const auto lay_out = [&] { return LayOut(*punctured, flat.on_input, &layout); };
    if (Status s = Timed(&seconds_.layout, lay_out); !s.ok()) return s;
    if (wants_exact_ && !map_.exact_map) {
      control_.BeginStage("exact map");
      const Status made = Timed(&seconds_.exact, [&] {
        return MakeExactOnSphere(surface_, intrinsic, options_, in_plane_, layout,
                                 control_.cancelled, &map_);
      });
      if (!made.ok()) return made;
      map_.certificate.exact_map->exact_layout_closure = map_.certificate.layout->layout_closure;
    }
    const bool is_first = map_.exact_map && !first_.sphere;
    const Status placed =
        Timed(&seconds_.layout, [&] { return placement_.Place(std::move(layout)); });
    if (is_first) first_ = map_.certificate;
    return placed;
  }

  /// Lengths whose angles the flat ones are fitted to.
  EdgeLengths ReferenceLengths(const IntrinsicTriangulation& intrinsic,
                               const PuncturedSurface& punctured) const {
    if (options_.inversion) {
      return InvertedLengths(surface_, intrinsic.triangulation, intrinsic.lengths, punctured);
    }
    return LengthsOf(punctured, intrinsic.triangulation, intrinsic.lengths);
  }

  Status FlattenWithConvexLink(const IntrinsicSurface& plane, FlatSurface* flat) {
    Status status;
    for (const double margin : {in_plane_.epsilon, kLeastLinkMargin}) {
      summary_.link_margin = margin;
      const ConeTargets targets = ConvexLinkTargets(plane, margin);
      status = Flatten({plane, targets, in_plane_, control_}, &map_.certificate, flat);
      if (status.code() != StatusCode::kInfeasible) break;
    }
    return status;
  }

  Status LayOut(const PuncturedSurface& punctured, const InputChart& flat, PlaneWithPole* plane) {
    const Triangulation& t = punctured.triangulation;
    control_.BeginStage("layout");
    const StatusOr<PlanarLayout> laid_out = LayOutBy(in_plane_.layout, t, flat);
    if (!laid_out.ok()) return laid_out.status();
    const PlanarLayout& layout = *laid_out;
    Fill(&map_.certificate.layout).layout_closure = layout.closure;
    plane->pole = punctured.pole;
    plane->position.assign(t_.num_vertices, Eigen::Vector2d::Zero());
    for (Index h = 0; h < t.num_halfedges(); ++h) {
      plane->position[punctured.vertex[t.vertex[h]]] = layout.uv.value[h];
    }
    return Status();
  }

  /// True of every pole's map then.
  bool IsBeyondDoubles() const { return log_radius_range_ > kGreatestLogRadiusRange; }

  Status BeyondDoubles() const {
    return Status(
        StatusCode::kUnrepresentable,
        fmt::format(
            "doubles cannot hold this surface on one sphere, from whichever pole: the radii "
            "of its circles span e^{:.0f}, as those of long thin limbs do; map it to the "
            "plane with cones instead (-cones=greedy)",
            log_radius_range_));
  }

  Status Unrepresentable() const {
    return Status(
        StatusCode::kUnrepresentable,
        fmt::format("a circle pattern exists but doubles cannot hold it on one sphere: log "
                    "radii range over {:.1f} and {} would collapse, faces {} (0-based) "
                    "among them; name another --pole or normalization",
                    log_radius_range_, Count(placement_.flipped().size(), "face"),
                    IdList(placement_.flipped(), 5)));
  }

  const Surface& surface_;
  const Triangulation& t_;
  const EdgeLengths& lengths_;
  const DomainOptions& options_;
  ParameterizeOptions in_plane_;
  bool flips_ = true, wants_exact_ = false;
  const SolveControl& control_;
  SurfaceMap& map_;
  StageSeconds& seconds_;
  SphereSummary& summary_;
  double log_radius_range_ = 0;
  Index pole_ = kNone;
  Certificate first_;  ///< of the solve that the exact map is of
  SpherePlacement placement_;
};

}  // namespace

Status MapToSphere(const Surface& surface, const MapRequest& request, const SolveControl& control,
                   SurfaceMap* map) {
  DomainOptions options = request.shape;
  if (options.normalization.empty()) options.normalization = kDefaultNormalization;
  if (Status s = CheckNormalization(options.normalization); !s.ok()) return s;
  if (Status s = CheckSurface(surface); !s.ok()) return s;
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  Status status = SphereMapping(surface, lengths, options, request.options, control, map).Run();
  if (!status.ok()) return status;
  const Timer timer;
  MeasureSphereMap(surface, lengths, map);
  map->certificate.seconds.measures = timer.Seconds();
  return status;
}

}  // namespace cirque

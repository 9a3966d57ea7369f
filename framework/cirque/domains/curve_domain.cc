#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cirque/core/solve_summary.h"
#include "cirque/domains/boundary_iteration.h"
#include "cirque/domains/built_in_domains.h"
#include "cirque/domains/corner_places.h"
#include "cirque/domains/curves.h"
#include "cirque/domains/half_plane_chart.h"
#include "cirque/domains/inscribed_in_curve.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/layout/landmarks.h"
#include "cirque/layout/stretch_energy.h"
#include "cirque/math/boundary_sweep.h"
#include "cirque/math/similarity.h"
#include "cirque/mesh/split_chords.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/finish_layout.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double kLeastAngle = 0.05 * kPi, kGreatestAngle = 1.75 * kPi;
constexpr double kShare = 0.8;  ///< of what a vertex's corners can reach

constexpr double kAtRest = 1e-7;  ///< of log lengths: what lies inside is refined afterwards

constexpr char kTooCoarse[] =
    "the map onto the curve exists, but triangles stay straight, and where all corners of one lie "
    "on "
    "the boundary the curve must turn outwards between them, which here it does not (split such "
    "triangles, or subdivide the mesh)";

/// The map as it is, with its figures, unless triangles of it are flipped.
Status Deliver(const Surface& surface, SurfaceMap* map) {
  std::vector<Complex> corners;
  for (const Vector2d& p : map->uv.value) corners.emplace_back(p.x(), p.y());
  return PutCorners(surface, corners, kTooCoarse, map);
}

/// A disk whose edges between boundary vertices are split, and its boundary from the vertex on that goes
/// to the curve's beginning.
class CurveFit {
 public:
  CurveFit(const Surface& disk, const ClosedCurve& curve, const MapRequest& request,
           const SolveControl& control)
      : disk_(disk),
        surface_(MeasureSurface(disk.triangulation, MeasureEdgeLengths(disk))),
        polygons_(curve),
        curve_(curve),
        request_(request),
        control_(control),
        loop_(BoundaryLoops(disk.triangulation).front()) {}

  /// Errors: those of Parameterize, where the surface has no map with a free boundary; cancelled.
  Status Run(SurfaceMap* map) {
    Status status = MapFreely(map);
    if (!status.ok()) return status;
    Begin(*map);
    const VectorXd start = LogLengths(map->flat.on_input.lengths);
    const BoundaryRule rule = {[this](const VectorXd& shape) { return Targets(shape); },
                               [this](const VectorXd& shape, const EdgeLengths& flat) {
                                 return polygons_.Missing(shape, Lengths(flat));
                               },
                               start, VectorXd::Ones(start.size()), kAtRest};
    BoundaryIteration iteration(disk_, rule, request_.options, control_);
    SurfaceMap failed;
    status = iteration.Run(&failed);
    summary_.rounds = 1 + iteration.rounds();
    if (status.code() == StatusCode::kCancelled) return status;
    if (status.ok()) *map = std::move(iteration.map());
    const VectorXd shape = status.ok() ? iteration.shape() : start;
    summary_.length_mismatch =
        polygons_.Missing(shape, Lengths(map->flat.on_input.lengths)).cwiseAbs().maxCoeff();
    return PlaceOn(polygons_.Arcs(shape));
  }

  const CurveSummary& summary() const { return summary_; }
  const std::vector<Index>& loop() const { return vertex_; }
  const std::vector<Vector2d>& corners() const { return corner_; }

 private:
  Status MapFreely(SurfaceMap* map) {
    ParameterizeOptions options = request_.options;
    options.refine_map = "none";
    return Parameterize(disk_, {options, FreeBoundaryTargets(disk_.triangulation), {}, {}},
                        control_, map);
  }

  /// Turns the loop to where it begins, which nobody named: where the free boundary turns as the curve.
  void Begin(const SurfaceMap& free) {
    const Triangulation& t = disk_.triangulation;
    const Index named = request_.shape.angle_zero;
    auto first = loop_.begin();
    if (named == kNone) {
      const std::vector<double> sum = VertexAngleSums(t, free.flat.on_input.angles);
      VectorXd angles(static_cast<Eigen::Index>(loop_.size()));
      for (std::size_t k = 0; k < loop_.size(); ++k) {
        angles[static_cast<Eigen::Index>(k)] = sum[t.Tail(loop_[k])];
      }
      first += NearestStart(curve_, Lengths(free.flat.on_input.lengths), angles);
    } else {
      first = std::find_if(loop_.begin(), loop_.end(), [&](Index h) { return t.Tail(h) == named; });
    }
    std::rotate(loop_.begin(), first, loop_.end());
    for (const Index h : loop_) vertex_.push_back(t.Tail(h));
    summary_.start_vertex = disk_.soup_vertex[vertex_[0]];
    Bound();
  }

  void Bound() {
    lower_ = VectorXd::Constant(static_cast<Eigen::Index>(loop_.size()), kLeastAngle);
    upper_ = lower_;
    for (std::size_t k = 0; k < vertex_.size(); ++k) {
      upper_[static_cast<Eigen::Index>(k)] =
          std::min(kGreatestAngle, kShare * kPi * surface_.corners[vertex_[k]]);
    }
  }

  VectorXd Lengths(const EdgeLengths& lengths) const {
    VectorXd of_loop(static_cast<Eigen::Index>(loop_.size()));
    for (std::size_t k = 0; k < loop_.size(); ++k) {
      of_loop[static_cast<Eigen::Index>(k)] = lengths.value[disk_.triangulation.edge[loop_[k]]];
    }
    return of_loop;
  }

  VectorXd LogLengths(const EdgeLengths& lengths) const { return Lengths(lengths).array().log(); }

  ConeTargets Targets(const VectorXd& shape) const {
    ConeTargets targets = FreeBoundaryTargets(disk_.triangulation);
    const VectorXd angles = polygons_.Angles(shape, lower_, upper_);
    for (std::size_t k = 0; k < vertex_.size(); ++k) {
      const double angle = angles[static_cast<Eigen::Index>(k)];
      targets.lower[vertex_[k]] = targets.upper[vertex_[k]] = angle;
    }
    return targets;
  }

  Status PlaceOn(std::vector<double> arcs) {
    summary_.corners = polygons_.MeetCorners(&arcs);
    corner_ = polygons_.Corners(arcs);
    std::vector<DirectedSegment> sides;
    for (std::size_t k = 0; k < corner_.size(); ++k) {
      sides.push_back({corner_[k], corner_[(k + 1) % corner_.size()]});
      if (sides.back().tail == sides.back().tip) return TooFewVertices();
    }
    return FindOverlap(sides, Contacts::kEndsOnly) ? TooFewVertices() : Status();
  }

  Status TooFewVertices() const {
    return Status(
        StatusCode::kUnrepresentable,
        fmt::format("curve: joined by straight edges, the {} vertices of the boundary meet "
                    "one another where they lie on the curve, which is too fine for them "
                    "(subdivide the mesh, or take a smoother curve)",
                    corner_.size()));
  }

  const Surface& disk_;
  const IntrinsicSurface surface_;
  const InscribedPolygons polygons_;
  const ClosedCurve& curve_;
  const MapRequest& request_;
  const SolveControl& control_;
  std::vector<Index> loop_;    ///< halfedges of the boundary
  std::vector<Index> vertex_;  ///< their tails
  VectorXd lower_, upper_;
  std::vector<Vector2d> corner_;  ///< where the boundary's vertices lie on the curve
  CurveSummary summary_;
};

/// Per vertex of the disk where it is laid out, moved nearest to where the boundary is to lie.
std::vector<Complex> PlacesNearCurve(const Triangulation& t, const CornerUv& uv,
                                     const CurveFit& fit) {
  std::vector<Complex> place(t.num_vertices), from, to;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    place[t.vertex[h]] = {uv.value[h].x(), uv.value[h].y()};
  }
  for (std::size_t k = 0; k < fit.loop().size(); ++k) {
    from.push_back(place[fit.loop()[k]]);
    to.emplace_back(fit.corners()[k].x(), fit.corners()[k].y());
  }
  const Similarity similarity = NearestSimilarity(from, to).value_or(Similarity());
  for (Complex& z : place) z = similarity(z);
  return place;
}

/// The same with the boundary on the curve; how far its farthest vertex moved, over the square root of
/// the curve's area.
double PutOnCurve(const CurveFit& fit, double area, std::vector<Complex>* place) {
  double farthest = 0;
  for (std::size_t k = 0; k < fit.loop().size(); ++k) {
    Complex& z = (*place)[fit.loop()[k]];
    const Complex to(fit.corners()[k].x(), fit.corners()[k].y());
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
Status BendOntoCurve(const IntrinsicSurface& surface, const CurveFit& fit,
                     const SolveControl& control, CornerUv* uv, CurveSummary* summary) {
  std::vector<Landmark> landmarks;
  for (std::size_t k = 0; k < fit.loop().size(); ++k) {
    landmarks.push_back({fit.loop()[k], fit.corners()[k]});
  }
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
      fmt::format("curve: the map could not be bent onto it without flipping triangles; a "
                  "vertex of the boundary stays {:.2g} of the image's size away from its "
                  "place (a finer mesh may help, or a curve nearer to what the boundary of "
                  "a map with a free boundary looks like)",
                  bent->miss_after));
}

/// Puts the boundary onto the curve and refines what lies inside.
Status FinishOnCurve(const Surface& surface, const CurveFit& fit, double area,
                     std::vector<Complex> place, const MapRequest& request,
                     const SolveControl& control, SurfaceMap* map) {
  const Triangulation& t = surface.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const IntrinsicSurface intrinsic = MeasureSurface(t, lengths);
  CurveSummary& summary = *map->certificate.curve;
  const CornerUv near = UvOf(t, place);
  summary.shift = PutOnCurve(fit, area, &place);
  map->uv = UvOf(t, place);
  control.BeginStage("refinement");
  if (!FlippedFaces(t, map->uv).empty()) {
    map->uv = near;
    if (!FlippedFaces(t, near).empty()) return Deliver(surface, map);
    if (Status s = BendOntoCurve(intrinsic, fit, control, &map->uv, &summary); !s.ok()) return s;
  }
  const Status status =
      RefineHeldMap(intrinsic, {intrinsic.boundary}, request.options.refine_map, control.cancelled,
                    &map->uv, &map->certificate.map_refinement);
  return status.ok() ? Deliver(surface, map) : status;
}

Status CheckStart(const Surface& surface, const std::vector<Index>& loop, Index start) {
  const auto starts = [&](Index h) { return surface.triangulation.Tail(h) == start; };
  if (start == kNone || std::any_of(loop.begin(), loop.end(), starts)) return Status();
  return Status::InvalidInput(
      fmt::format("angle_zero: vertex {} (0-based) is no vertex of the boundary, of which it is to "
                  "be the one at the curve's first point",
                  surface.soup_vertex[start]));
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
  CurveFit fit(split, *curve, request, control);
  const Status solved = fit.Run(map);
  if (solved.code() == StatusCode::kInfeasible && !none) {
    map->flat.infeasibility = {};
    map->certificate.infeasibility = {};
    return Status(StatusCode::kNotConverged,
                  "with edges between two vertices of the boundary split, the mesh has no circle "
                  "pattern; subdivide it");
  }
  if (!solved.ok()) return solved;
  map->certificate.curve = fit.summary();
  map->certificate.curve->chords = static_cast<int>(std::count(chords.begin(), chords.end(), true));
  std::vector<Complex> place = PlacesNearCurve(split.triangulation, map->uv, fit);
  place.resize(t.num_vertices);
  map->flat = {};
  map->targets = {};
  ForgetCut(t, map);
  return FinishOnCurve(surface, fit, curve->Area(), std::move(place), request, control, map);
}

}  // namespace cirque

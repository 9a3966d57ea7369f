#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/QR>
#include <fmt/format.h>

#include "cirque/core/solve_summary.h"
#include "cirque/domains/boundary_iteration.h"
#include "cirque/domains/built_in_domains.h"
#include "cirque/domains/corner_places.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/math/inscribed_polygon.h"
#include "cirque/mesh/split_chords.h"
#include "cirque/pipeline/finish_layout.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;
using Loop = std::vector<Index>;

/// Of a round's change. A wave of n periods on the outer circle comes back 1/n as high, on a hole's
/// -1/n, of which that of one period would stay.
constexpr double kOuterShare = 1, kHoleShare = 2.0 / 3;

/// The loops, the longest first.
std::vector<Loop> LoopsByLength(const Surface& surface) {
  const Triangulation& t = surface.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  std::vector<Loop> loops = BoundaryLoops(t);
  const auto length = [&](const Loop& loop) {
    double sum = 0;
    for (const Index h : loop) sum += lengths.value[t.edge[h]];
    return sum;
  };
  std::stable_sort(loops.begin(), loops.end(),
                   [&](const Loop& a, const Loop& b) { return length(a) > length(b); });
  return loops;
}

Status CheckSurface(const Surface& surface, const std::vector<Loop>& loops) {
  const Triangulation& t = surface.triangulation;
  const auto count = static_cast<Index>(loops.size());
  const Index chi = EulerCharacteristic(t);
  if (count < 2 || chi != 2 - count) {
    return Status::InvalidInput(
        fmt::format("the domain round_holes takes a surface of genus 0 with two or more boundary "
                    "loops, of which the longest goes round the others; this one is of genus {} "
                    "with {} boundary loops",
                    (2 - count - chi) / 2, count));
  }
  for (Index k = 1; k < count; ++k) {
    const std::vector<bool> chords = ChordsOf(t, loops[k]);
    const auto chord = std::find(chords.begin(), chords.end(), true) - chords.begin();
    if (chord == t.num_edges()) continue;
    const Index h = t.edge_halfedge[chord];
    return Status::InvalidInput(fmt::format(
        "an edge joins two vertices of one hole, {} and {} (0-based), and would lead straight "
        "through the hole once that is round: split such edges, or subdivide the mesh",
        surface.soup_vertex[t.Tail(h)], surface.soup_vertex[t.Tip(h)]));
  }
  return Status();
}

/// The shape of a boundary: logarithms of the shares that its edges have of their loop.
class LoopShapes {
 public:
  LoopShapes(const Triangulation& t, const std::vector<Loop>& loops) : t_(t), loops_(loops) {
    for (const Loop& loop : loops) size_ += static_cast<Eigen::Index>(loop.size());
  }

  Eigen::VectorXd ShapeOf(const EdgeLengths& lengths) const {
    Eigen::VectorXd shape(size_);
    Eigen::Index at = 0;
    for (const Loop& loop : loops_) {
      double total = 0;
      for (const Index h : loop) total += lengths.value[t_.edge[h]];
      for (const Index h : loop) shape[at++] = std::log(lengths.value[t_.edge[h]] / total);
    }
    return shape;
  }

  /// What a round may change of a shape.
  Eigen::VectorXd Shares() const {
    Eigen::VectorXd shares = Eigen::VectorXd::Constant(size_, kHoleShare);
    shares.head(static_cast<Eigen::Index>(loops_[0].size())).setConstant(kOuterShare);
    return shares;
  }

  /// The angle sums of loops that are inscribed in circles with edges of this shape: the outer one
  /// turns by 2 pi, holes by -2 pi.
  ConeTargets Inscribed(const Eigen::VectorXd& shape) const {
    ConeTargets targets = FreeBoundaryTargets(t_);
    Eigen::Index at = 0;
    for (const Loop& loop : loops_) {
      std::vector<double> lengths(loop.size());
      for (double& length : lengths) length = std::exp(shape[at++]);
      const std::vector<double> half = HalfCentralAngles(std::move(lengths));
      const double way = &loop == &loops_[0] ? -1 : 1;
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const double turn = half[k] + half[k == 0 ? half.size() - 1 : k - 1];
        const Index v = t_.Tail(loop[k]);
        targets.lower[v] = targets.upper[v] = kPi + way * turn;
      }
    }
    return targets;
  }

 private:
  const Triangulation& t_;
  const std::vector<Loop>& loops_;
  Eigen::Index size_ = 0;
};

/// Flattens with the loops inscribed, by the lengths that come out again, until these stay.
Status RoundLoops(const Surface& surface, const std::vector<Loop>& loops, const MapRequest& request,
                  const SolveControl& control, SurfaceMap* map, int* rounds) {
  const LoopShapes shapes(surface.triangulation, loops);
  const BoundaryRule rule = {
      [&](const Eigen::VectorXd& shape) { return shapes.Inscribed(shape); },
      [&](const Eigen::VectorXd& shape, const EdgeLengths& flat) -> Eigen::VectorXd {
        return shapes.ShapeOf(flat) - shape;
      },
      shapes.ShapeOf(MeasureEdgeLengths(surface)), shapes.Shares()};
  BoundaryIteration iteration(surface, rule, request.options, control);
  const Status status = iteration.Run(map);
  *rounds = iteration.rounds();
  if (!status.ok()) return status;
  *map = std::move(iteration.map());
  if (iteration.IsSettled()) return Status();
  return Status(StatusCode::kNotConverged,
                fmt::format("round_holes: after {} rounds edges of the boundary still change by "
                            "{:.1e} of their lengths (a finer mesh may help)",
                            *rounds, iteration.change()));
}

/// The mean of the places of every vertex, which the seams part by rounding.
std::vector<Complex> MeanPlaces(const Triangulation& t, const CornerUv& uv) {
  std::vector<Complex> place(t.num_vertices);
  std::vector<double> corners(t.num_vertices, 0);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    place[t.vertex[h]] += Complex(uv.value[h].x(), uv.value[h].y());
    corners[t.vertex[h]] += 1;
  }
  for (Index v = 0; v < t.num_vertices; ++v) place[v] /= corners[v];
  return place;
}

struct Circle {
  Complex centre;
  double radius;

  double Miss(Complex z) const { return std::abs(std::abs(z - centre) / radius - 1); }
};

/// The circle of least sum (|z - c|^2 - r^2)^2 (I. Kasa, 1976).
Circle FitCircle(const Triangulation& t, const Loop& loop, const std::vector<Complex>& place) {
  Complex mean = 0;
  for (const Index h : loop) mean += place[t.Tail(h)] / static_cast<double>(loop.size());
  Eigen::MatrixX3d rows(static_cast<Eigen::Index>(loop.size()), 3);
  Eigen::VectorXd squares(rows.rows());
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    const Complex z = place[t.Tail(loop[k])] - mean;
    rows.row(k) << 2 * z.real(), 2 * z.imag(), 1;
    squares[k] = std::norm(z);
  }
  const Eigen::Vector3d fit = rows.colPivHouseholderQr().solve(squares);
  return {mean + Complex(fit.x(), fit.y()), std::sqrt(fit.z() + fit.head<2>().squaredNorm())};
}

/// Moves and scales the outer circle to the unit circle, and puts all boundary vertices on their
/// circles.
RoundHolesSummary PutOnCircles(const Triangulation& t, const std::vector<Loop>& loops,
                               std::vector<Complex>* place) {
  RoundHolesSummary summary;
  summary.holes = static_cast<int>(loops.size()) - 1;
  const Circle outer = FitCircle(t, loops[0], *place);
  for (Complex& z : *place) z = (z - outer.centre) / outer.radius;
  double roundness = 0, error = 0;
  for (const Loop& loop : loops) {
    const bool is_outer = &loop == &loops[0];
    const Circle circle = is_outer ? Circle{0, 1} : FitCircle(t, loop, *place);
    for (const Index h : loop) {
      Complex& z = (*place)[t.Tail(h)];
      roundness = std::max(roundness, circle.Miss(z));
      z = circle.centre + circle.radius / std::abs(z - circle.centre) * (z - circle.centre);
      error = std::max(error, circle.Miss(z));
    }
    if (is_outer) continue;
    const bool first = &loop == &loops[1];
    if (first || circle.radius < summary.smallest_radius) summary.smallest_radius = circle.radius;
    if (first || circle.radius > summary.largest_radius) summary.largest_radius = circle.radius;
  }
  summary.roundness = roundness;
  summary.circle_error = error;
  return summary;
}

/// The places of all corners, without flipped triangles refined: inner vertices move, those of the
/// outer circle slide along it.
Status RefineBetweenCircles(const Surface& surface, const std::vector<Loop>& loops,
                            const MapRequest& request, const SolveControl& control,
                            std::vector<Complex>* place, SurfaceMap* map) {
  const Triangulation& t = surface.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const IntrinsicSurface intrinsic = MeasureSurface(t, lengths);
  KeptVertices kept{intrinsic.boundary};
  kept.sliding.slides.assign(t.num_vertices, false);
  for (const Index h : loops[0]) {
    kept.sliding.slides[t.Tail(h)] = true;
    kept.held[t.Tail(h)] = false;
  }
  CornerUv uv = map->uv;
  Status status = RefineHeldMap(intrinsic, std::move(kept), request.options.refine_map,
                                control.cancelled, &uv, &map->certificate.map_refinement);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    (*place)[h] = {uv.value[h].x(), uv.value[h].y()};
  }
  return status;
}

constexpr char kTooCoarse[] =
    "the circle pattern with round holes exists, but triangles, which stay straight, are too large "
    "for its circles (subdivide the mesh)";

/// What is solved for: without the outer loop's chords.
Status SolveWithoutChords(const Surface& surface, const std::vector<Loop>& loops,
                          const MapRequest& request, const SolveControl& control, SurfaceMap* map) {
  const std::vector<bool> chords = ChordsOf(surface.triangulation, loops[0]);
  const bool none = std::find(chords.begin(), chords.end(), true) == chords.end();
  const Surface split = none ? surface : SplitEdges(surface, chords);
  // Halves of boundary edges there are none: loops keep their vertices.
  const std::vector<Loop> solved = LoopsByLength(split);
  const Triangulation& t = split.triangulation;
  int rounds = 0;
  const Status rounded = RoundLoops(split, solved, request, control, map, &rounds);
  if (rounded.code() == StatusCode::kInfeasible && !none) {
    ForgetProof(map);
    return Status(StatusCode::kNotConverged,
                  "with edges between two vertices of the outer boundary split, the mesh has no "
                  "circle pattern with round boundaries; subdivide it");
  }
  if (!rounded.ok()) return rounded;
  std::vector<Complex> place = MeanPlaces(t, map->uv);
  RoundHolesSummary summary = PutOnCircles(t, solved, &place);
  summary.rounds = rounds;
  summary.chords = static_cast<int>(std::count(chords.begin(), chords.end(), true));
  map->certificate.round_holes = summary;
  const Triangulation& whole = surface.triangulation;
  std::vector<Complex> corners;
  for (const Index v : whole.vertex) corners.push_back(place[v]);
  map->flat = {};
  map->targets = {};
  ForgetCut(whole, map);
  Status status = PutCorners(surface, corners, kTooCoarse, map);
  if (!status.ok()) return status;
  control.BeginStage("refinement");
  status = RefineBetweenCircles(surface, loops, request, control, &corners, map);
  return status.ok() ? PutCorners(surface, corners, kTooCoarse, map) : status;
}

}  // namespace

Status MapToRoundHoles(const Surface& surface, const MapRequest& request,
                       const SolveControl& control, SurfaceMap* map) {
  const std::vector<Loop> loops = LoopsByLength(surface);
  const Status status = CheckSurface(surface, loops);
  return status.ok() ? SolveWithoutChords(surface, loops, request, control, map) : status;
}

}  // namespace cirque

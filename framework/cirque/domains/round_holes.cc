#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <fmt/format.h>

#include "cirque/core/solve_summary.h"
#include "cirque/domains/boundary_iteration.h"
#include "cirque/domains/built_in_domains.h"
#include "cirque/domains/corner_places.h"
#include "cirque/domains/exact_disk.h"
#include "cirque/domains/round_circles.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/math/inscribed_polygon.h"
#include "cirque/mesh/split_chords.h"
#include "cirque/pipeline/exact_layout.h"
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

/// What the rounds of a boundary lead to.
struct RoundShape {
  Eigen::VectorXd shape;
  int rounds = 0;
};

/// Flattens with the loops inscribed, by the lengths that come out again, until these stay.
StatusOr<RoundShape> RoundLoops(const Surface& surface, const LoopShapes& shapes,
                                Eigen::VectorXd start, const ParameterizeOptions& options,
                                const SolveControl& control, SurfaceMap* map) {
  const BoundaryRule rule = {
      [&](const Eigen::VectorXd& shape) { return shapes.Inscribed(shape); },
      [&](const Eigen::VectorXd& shape, const EdgeLengths& flat) -> Eigen::VectorXd {
        return shapes.ShapeOf(flat) - shape;
      },
      std::move(start), shapes.Shares()};
  BoundaryIteration iteration(surface, rule, options, control);
  const Status status = iteration.Run(map);
  if (!status.ok()) return status;
  *map = std::move(iteration.map());
  if (iteration.IsSettled()) return RoundShape{iteration.shape(), iteration.rounds()};
  return Status(StatusCode::kNotConverged,
                fmt::format("round_holes: after {} rounds edges of the boundary still change by "
                            "{:.1e} of their lengths (a finer mesh may help)",
                            iteration.rounds(), iteration.change()));
}

/// Refines a map without flipped triangles: inner vertices move, those of the outer circle slide along
/// it.
Status RefineBetweenCircles(const IntrinsicSurface& surface, const Loop& outer,
                            const std::string& refine_map, const SolveControl& control,
                            CornerUv* uv, std::optional<MapRefinementSummary>* summary) {
  const Triangulation& t = surface.triangulation;
  KeptVertices kept{surface.boundary};
  kept.sliding.slides.assign(t.num_vertices, false);
  for (const Index h : outer) {
    kept.sliding.slides[t.Tail(h)] = true;
    kept.held[t.Tail(h)] = false;
  }
  return RefineHeldMap(surface, std::move(kept), refine_map, control.cancelled, uv, summary);
}

/// The surface that is solved for: without the outer loop's chords.
struct WithoutChords {
  std::vector<bool> chords;  ///< of the surface's edges
  Surface split = {};
  std::vector<Loop> loops = {};     ///< of it; halves of boundary edges there are none
  std::vector<Index> part_of = {};  ///< per face of it the one of the surface
  Index num_wholes = 0;             ///< faces of the surface

  bool IsWhole() const { return std::find(chords.begin(), chords.end(), true) == chords.end(); }
};

/// Puts the layout of what was solved on its circles, for its exact map.
Status PutLayoutOnCircles(const WithoutChords& solved, const ParameterizeOptions& options,
                          const SolveControl& control, SolvedLayout* layout) {
  const Triangulation& t = layout->surface.triangulation;
  const Index on_outer = solved.split.triangulation.Tail(solved.loops[0].front());
  std::vector<Loop> loops = BoundaryLoops(t);
  const auto outer = std::find_if(loops.begin(), loops.end(), [&](const Loop& loop) {
    return std::any_of(loop.begin(), loop.end(), [&](Index h) { return t.Tail(h) == on_outer; });
  });
  std::iter_swap(loops.begin(), outer);
  std::vector<Complex> place = MeanPlaces(t, layout->uv);
  PutOnCircles(t, loops, &place);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    layout->uv.value[h] = {place[t.vertex[h]].real(), place[t.vertex[h]].imag()};
  }
  layout->cut.edge.assign(t.num_edges(), false);
  Status status = CheckSolvedNotFlipped(t, layout->uv, "a finer mesh, or the plane");
  if (!status.ok() || !layout->is_circle_pattern) return status;
  std::optional<MapRefinementSummary> unused;
  status = RefineBetweenCircles(layout->surface, loops[0], options.refine_map, control, &layout->uv,
                                &unused);
  return status.ok() ? CheckSolvedNotFlipped(t, layout->uv, "a finer mesh, or the plane") : status;
}

/// Makes the exact map of `solved.split`: the boundary's shape again by the metric that it is of, the
/// first solve's, which where edges were locked later is another one.
Status MakeExactRound(const WithoutChords& solved, const LoopShapes& shapes,
                      const Eigen::VectorXd& start, const ParameterizeOptions& options,
                      const SolveControl& control, SurfaceMap* drawn) {
  const auto round = RoundLoops(solved.split, shapes, start, options, control, drawn);
  if (!round.ok()) return round.status().In("the exact map");
  ParameterizeRequest last = {options, shapes.Inscribed(round->shape)};
  last.options.refine_map = "none";
  last.place_exact = [&](SolvedLayout* layout) {
    layout->part_of = &solved.part_of;
    layout->num_wholes = solved.num_wholes;
    return PutLayoutOnCircles(solved, options, control, layout);
  };
  return Parameterize(solved.split, last, control, drawn);
}

/// The exact map of the surface. Where flips made triangles of vertices of one hole alone, which lead
/// through it once it is round, it is that of the pattern on the surface's own triangles.
Status AddExactMap(const Surface& surface, const WithoutChords& solved, const LoopShapes& shapes,
                   const Eigen::VectorXd& start, ParameterizeOptions options,
                   const SolveControl& control, SurfaceMap* map) {
  const Triangulation& t = surface.triangulation;
  SurfaceMap drawn;
  const auto make = [&] { return MakeExactRound(solved, shapes, start, options, control, &drawn); };
  Status status = make();
  const bool may_do_better = status.code() == StatusCode::kUnrepresentable &&
                             options.triangulation != SolvedTriangulation::kInput;
  if (may_do_better) {
    options.triangulation = SolvedTriangulation::kInput;
    status = make();
  }
  if (!status.ok()) return status;
  return TakeExactMap(t, solved.chords, solved.split.triangulation, &drawn, map);
}

constexpr char kTooCoarse[] =
    "the circle pattern with round holes exists, but triangles, which stay straight, are too large "
    "for its circles (subdivide the mesh)";

/// Puts the vertices of the surface where they are on their circles, and refines the map.
Status FinishOnCircles(const Surface& surface, const std::vector<Loop>& loops,
                       const std::vector<Complex>& place, const MapRequest& request,
                       const SolveControl& control, SurfaceMap* map) {
  const Triangulation& t = surface.triangulation;
  std::vector<Complex> corners;
  for (const Index v : t.vertex) corners.push_back(place[v]);
  map->flat = {};
  map->targets = {};
  ForgetCut(t, map);
  Status status = PutCorners(surface, corners, kTooCoarse, map);
  if (!status.ok() || map->certificate.layout->flipped_triangles > 0) return status;
  control.BeginStage("refinement");
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  status = RefineBetweenCircles(MeasureSurface(t, lengths), loops[0], request.options.refine_map,
                                control, &map->uv, &map->certificate.map_refinement);
  return status.ok() ? MeasurePlaced(surface, kTooCoarse, map) : status;
}

Status SolveWithoutChords(const Surface& surface, const std::vector<Loop>& loops,
                          const MapRequest& request, const SolveControl& control, SurfaceMap* map) {
  WithoutChords solved{ChordsOf(surface.triangulation, loops[0])};
  solved.split = solved.IsWhole() ? surface : SplitEdges(surface, solved.chords);
  solved.loops = LoopsByLength(solved.split);
  solved.part_of = FacesBeforeSplit(surface.triangulation, solved.chords);
  solved.num_wholes = surface.triangulation.num_faces();
  const Triangulation& t = solved.split.triangulation;
  const LoopShapes shapes(t, solved.loops);
  ParameterizeOptions at_vertices = request.options;
  at_vertices.exact = false;
  const auto rounded =
      RoundLoops(solved.split, shapes, shapes.ShapeOf(MeasureEdgeLengths(solved.split)),
                 at_vertices, control, map);
  if (rounded.status().code() == StatusCode::kInfeasible && !solved.IsWhole()) {
    ForgetProof(map);
    return Status(StatusCode::kNotConverged,
                  "with edges between two vertices of the outer boundary split, the mesh has no "
                  "circle pattern with round boundaries; subdivide it");
  }
  if (!rounded.ok()) return rounded.status();
  std::vector<Complex> place = MeanPlaces(t, map->uv);
  RoundHolesSummary summary = PutOnCircles(t, solved.loops, &place);
  summary.rounds = rounded->rounds;
  summary.chords = static_cast<int>(std::count(solved.chords.begin(), solved.chords.end(), true));
  map->certificate.round_holes = summary;
  if (request.options.exact) {
    const Timer timer;
    Status made =
        AddExactMap(surface, solved, shapes, rounded->shape, request.options, control, map);
    AddSeconds(timer, &map->certificate.seconds.exact);
    if (!made.ok()) return made;
  }
  return FinishOnCircles(surface, loops, place, request, control, map);
}

}  // namespace

Status MapToRoundHoles(const Surface& surface, const MapRequest& request,
                       const SolveControl& control, SurfaceMap* map) {
  const std::vector<Loop> loops = LoopsByLength(surface);
  const Status status = CheckSurface(surface, loops);
  return status.ok() ? SolveWithoutChords(surface, loops, request, control, map) : status;
}

}  // namespace cirque

#include "cirque/pipeline/half_plane_chart.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cirque/layout/half_plane.h"
#include "cirque/layout/planar_layout.h"
#include "cirque/mesh/corner_angles.h"
#include "cirque/pipeline/flatten.h"

namespace cirque {
namespace {

constexpr int kMaxRounds = 4;  ///< of locking the edges of flipped triangles
constexpr int kMaxPoles = 3;   ///< that are tried where none is given

/// The boundary loop of the surface from the vertex `first` on, with arc lengths.
void FollowBoundary(const Triangulation& t, const EdgeLengths& lengths, PuncturedDisk* disk) {
  std::vector<Index> loop = BoundaryLoops(t).front();
  const auto at_pole = [&](Index h) { return t.Tail(h) == disk->pole; };
  std::rotate(loop.begin(), std::find_if(loop.begin(), loop.end(), at_pole), loop.end());
  double total = 0;
  for (const Index h : loop) {
    disk->loop.push_back(t.Tail(h));
    disk->arc.push_back(total);
    total += lengths.value[t.edge[h]];
  }
  for (double& share : disk->arc) share /= total;
}

/// The vertices along the boundary of the rest that is no link of the pole.
std::vector<Index> StraightChain(const Triangulation& whole, const PuncturedDisk& disk) {
  const Triangulation& t = disk.rest.triangulation;
  std::vector<Index> loop = BoundaryLoops(t).front();
  const auto in_link = [&](Index h) {
    const Index g = whole.twin[disk.rest.Halfedge(h)];
    return g != kNone && disk.core[Triangulation::Face(g)];
  };
  const auto link = std::find_if(loop.begin(), loop.end(), in_link);
  std::rotate(loop.begin(), link, loop.end());
  std::vector<Index> chain;
  for (const Index h : loop) {
    if (in_link(h)) continue;
    if (chain.empty()) chain.push_back(t.Tail(h));
    chain.push_back(t.Tip(h));
  }
  return chain;
}

/// Straight but for the ends of the chain; convex along the link, which is the rest of the
/// boundary.
ConeTargets StraightTargets(const PuncturedDisk& disk, double epsilon) {
  const Triangulation& t = disk.rest.triangulation;
  ConeTargets targets = FreeBoundaryTargets(t);
  const std::vector<bool> boundary = BoundaryVertices(t);
  const std::vector<Index> corners = CornersPerVertex(t);
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (boundary[v] && corners[v] > 1) targets.upper[v] = kPi - epsilon;
  }
  for (const Index v : disk.chain) targets.lower[v] = targets.upper[v] = kPi;
  for (const Index v : {disk.chain.front(), disk.chain.back()}) {
    targets.lower[v] = 0;
    targets.upper[v] = 0.5 * (kPi - epsilon);
  }
  return targets;
}

/// Fixes the angle sums along the link too, so that the pole's own triangles keep their shapes:
/// with the pole at infinity their circles are the link's lines, which turn at a vertex by the
/// intersection angle theta of the circles at its edge to the pole, half of it at the ends of the
/// chain, where the mirror image has the other half. Scaled so that the pole's angle sum becomes
/// pi, the angles turn by pi in all.
void KeepStar(const Triangulation& whole, const CornerAngles& angles, double epsilon,
              PuncturedDisk* disk) {
  constexpr double kLeast = 0.05;  // [rad] left for the angle sum of a link vertex
  const SubTriangulation& rest = disk->rest;
  double around_pole = 0;
  const auto for_each_star_corner = [&](const auto& visit) {
    for (Index h = 0; h < whole.num_halfedges(); ++h) {
      if (whole.vertex[h] == disk->pole && disk->core[Triangulation::Face(h)]) visit(h);
    }
  };
  for_each_star_corner([&](Index h) { around_pole += angles.value[h]; });
  std::vector<double> opposite(rest.triangulation.num_vertices, -1);  // of the edge to the pole
  for_each_star_corner([&](Index h) {
    const Index next = Triangulation::Next(h), prev = Triangulation::Prev(h);
    const double surplus = 0.5 * angles.value[h] * (1 - kPi / around_pole);
    for (const auto& [corner, other] : {std::pair(next, prev), std::pair(prev, next)}) {
      double& sum = opposite[rest.of_vertex[whole.vertex[other]]];
      sum = std::max(sum, 0.0) + angles.value[corner] + surplus;
    }
  });
  const auto straight = [&](Index v) {
    return v == disk->chain.front() || v == disk->chain.back() ? 0.5 * kPi : kPi;
  };
  double turned = 0;
  for (Index v = 0; v < rest.triangulation.num_vertices; ++v) {
    if (opposite[v] < 0) continue;
    const double full = straight(v);
    opposite[v] = std::clamp(full - opposite[v], epsilon * full / kPi, full - kLeast);
    turned += opposite[v];
  }
  for (Index v = 0; v < rest.triangulation.num_vertices; ++v) {
    if (opposite[v] < 0) continue;
    disk->targets.lower[v] = disk->targets.upper[v] = straight(v) - opposite[v] * kPi / turned;
  }
}

PuncturedDisk TakeOffStar(const Triangulation& t, const EdgeLengths& lengths,
                          const std::vector<bool>& core, Index pole, double epsilon) {
  PuncturedDisk disk;
  disk.core = core;
  disk.pole = pole;
  FollowBoundary(t, lengths, &disk);
  std::vector<bool> keep = core;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (t.vertex[h] == pole) keep[Triangulation::Face(h)] = false;
  }
  disk.rest = KeepFaces(t, keep);
  if (disk.rest.face.empty()) return disk;
  disk.lengths = LengthsOf(disk.rest, t, lengths);
  disk.chain = StraightChain(t, disk);
  disk.targets = StraightTargets(disk, epsilon);
  return disk;
}

/// How far every edge is from Delaunay in the surface glued to its mirror image [rad].
std::vector<double> DelaunayExcess(const Triangulation& t, const CornerAngles& angles) {
  std::vector<double> excess(t.num_edges(), 0);
  for (Index h = 0; h < t.num_halfedges(); ++h) excess[t.edge[h]] += angles.value[h];
  for (Index e = 0; e < t.num_edges(); ++e) {
    excess[e] = std::max(0.0, excess[e] - (t.IsBoundaryEdge(e) ? 0.5 * kPi : kPi));
  }
  return excess;
}

/// The core's boundary vertices, the best poles first: where the boundary is straight already, as
/// are the neighbours, and where the edges are Delaunay.
std::vector<Index> RankPoles(const Triangulation& whole, const EdgeLengths& lengths,
                             const std::vector<bool>& core) {
  const SubTriangulation part = KeepFaces(whole, core);
  const Triangulation& t = part.triangulation;
  const CornerAngles angles = MeasureCornerAngles(t, LengthsOf(part, whole, lengths));
  const std::vector<double> excess = DelaunayExcess(t, angles);
  std::vector<double> bend(t.num_vertices, -kPi), fault(t.num_vertices, 0);
  for (Index h = 0; h < t.num_halfedges(); ++h) bend[t.vertex[h]] += angles.value[h];
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    const double bent = t.IsBoundaryEdge(e) ? 0.5 : 0;
    fault[t.Tail(h)] += excess[e] + bent * (std::abs(bend[t.Tail(h)]) + std::abs(bend[t.Tip(h)]));
    fault[t.Tip(h)] += excess[e] + bent * (std::abs(bend[t.Tail(h)]) + std::abs(bend[t.Tip(h)]));
  }
  std::vector<std::pair<double, Index>> ranked;
  const std::vector<Index> loop = BoundaryLoops(t).front();
  for (const Index h : loop) ranked.emplace_back(fault[t.Tail(h)], part.vertex[t.Tail(h)]);
  std::sort(ranked.begin(), ranked.end());
  std::vector<Index> poles;
  for (const auto& [unused, v] : ranked) poles.push_back(v);
  return poles;
}

/// Lengths of the edges along a chain of boundary vertices.
std::vector<double> ChainLengths(const Triangulation& t, const EdgeLengths& lengths,
                                 const std::vector<Index>& chain) {
  std::vector<double> from(t.num_vertices, 0);  // of the boundary edge that leaves a vertex
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (t.twin[h] == kNone) from[t.Tail(h)] = lengths.value[t.edge[h]];
  }
  std::vector<double> along;
  for (std::size_t k = 0; k + 1 < chain.size(); ++k) along.push_back(from[chain[k]]);
  return along;
}

class ChartSolve {
 public:
  ChartSolve(const Surface& surface, const ParameterizeOptions& options,
             const SolveControl& control, const FlipsOfChart& flips, Certificate* certificate,
             HalfPlaneChart* chart)
      : t_(surface.triangulation),
        lengths_(MeasureEdgeLengths(surface)),
        options_(options),
        control_(control),
        flips_(flips),
        certificate_(*certificate),
        chart_(*chart) {}

  Status Run(Index pole, bool* clean) {
    const std::vector<bool> core = LargestChordlessPiece(t_);
    const std::vector<Index> ranked = RankPoles(t_, lengths_, core);
    std::vector<Index> poles = {pole};
    if (pole == kNone) {
      poles.assign(ranked.begin(),
                   ranked.begin() + std::min<std::size_t>(kMaxPoles, ranked.size()));
    } else if (std::find(ranked.begin(), ranked.end(), pole) == ranked.end()) {
      return Status::InvalidInput(
          fmt::format("vertex {} (0-based) cannot be the pole: it is no boundary vertex, or lies "
                      "beyond an edge "
                      "that joins two boundary vertices; name another, or none",
                      pole));
    }
    Status status;
    for (const bool keep_star : {true, false}) {
      for (const Index candidate : poles) {
        status = SolveWithPole(core, candidate, keep_star, clean);
        if (status.code() != StatusCode::kInfeasible) return status;
      }
    }
    return status;
  }

 private:
  Status SolveWithPole(const std::vector<bool>& core, Index pole, bool keep_star, bool* clean) {
    chart_ = {};
    chart_.disk = TakeOffStar(t_, lengths_, core, pole, options_.epsilon);
    if (chart_.disk.rest.face.empty()) return Status();
    if (keep_star) {
      KeepStar(t_, MeasureCornerAngles(t_, lengths_), options_.epsilon, &chart_.disk);
    }
    return SolveWithLocks(clean);
  }

  Status SolveWithLocks(bool* clean) {
    std::vector<bool> locked(chart_.disk.rest.triangulation.num_edges(), false);
    for (int round = 0; round < kMaxRounds; ++round) {
      if (Status s = Solve(options_, locked); !s.ok()) return s;
      const std::vector<Index> flipped = flips_(chart_);
      *clean = flipped.empty();
      if (*clean || options_.triangulation == "input" || !chart_.increasing) return Status();
      if (!LockFlipped(flipped, &locked)) break;
    }
    ParameterizeOptions raw = options_;
    raw.triangulation = "input";
    HalfPlaneChart before = chart_;
    const Status status = Solve(raw, locked);
    if (status.ok()) *clean = flips_(chart_).empty();
    if (!*clean) chart_ = std::move(before);
    return status.code() == StatusCode::kCancelled ? status : Status();
  }

  /// False when there is no edge left to lock.
  bool LockFlipped(const std::vector<Index>& flipped, std::vector<bool>* locked) const {
    const SubTriangulation& rest = chart_.disk.rest;
    bool any = false;
    for (const Index f : flipped) {
      const auto found = std::lower_bound(rest.face.begin(), rest.face.end(), f);
      if (found == rest.face.end() || *found != f) continue;
      const auto own = static_cast<Index>(found - rest.face.begin());
      for (Index h = 3 * own; h < 3 * own + 3; ++h) {
        const Index e = rest.triangulation.edge[h];
        any = any || !(*locked)[e];
        (*locked)[e] = true;
      }
    }
    return any;
  }

  Status Solve(const ParameterizeOptions& options, const std::vector<bool>& locked) {
    const PuncturedDisk& disk = chart_.disk;
    const Triangulation& t = disk.rest.triangulation;
    FlatSurface flat;
    Status status =
        Flatten(t, disk.lengths, disk.targets, options, control_, &certificate_, &flat, locked);
    certificate_.infeasibility = {};  // it would speak of the rest, not of the surface
    if (!status.ok()) return status;
    const PlanarLayout layout = LayOutByDirections(t, flat.on_input.angles, flat.on_input.lengths);
    certificate_.values["layout_closure"] = layout.closure;
    const HalfPlane moved = MoveToHalfPlane(t, layout.uv, disk.chain);
    chart_.chain_length = ChainLengths(t, flat.on_input.lengths, disk.chain);
    chart_.straightness = moved.straightness;
    chart_.increasing = moved.increasing;
    chart_.position.assign(t_.num_vertices, 0);
    for (Index v = 0; v < t.num_vertices; ++v) {
      chart_.position[disk.rest.vertex[v]] = moved.position[v];
    }
    return status;
  }

  const Triangulation& t_;
  const EdgeLengths lengths_;
  const ParameterizeOptions& options_;
  const SolveControl& control_;
  const FlipsOfChart& flips_;
  Certificate& certificate_;
  HalfPlaneChart& chart_;
};

}  // namespace

Status CheckIsDisk(const Triangulation& t) {
  const std::size_t loops = BoundaryLoops(t).size();
  const Index euler = EulerCharacteristic(t);
  if (loops == 1 && euler == 1) return Status();
  if (loops == 0) {
    return Status::InvalidInput(
        "this domain takes a topological disk, and the surface is closed: cut it open first");
  }
  const Index genus = (2 - euler - static_cast<Index>(loops)) / 2;
  if (genus == 0) {
    return Status::InvalidInput(
        fmt::format("this domain takes a topological disk, and the surface has {} boundary loops; "
                    "fill all but the longest (--fill_holes)",
                    loops));
  }
  return Status::InvalidInput(
      fmt::format("this domain takes a topological disk, and the surface has genus {}: cut it open "
                  "first",
                  genus));
}

Status SolveHalfPlaneChart(const Surface& surface, Index pole, const ParameterizeOptions& options,
                           const SolveControl& control, const FlipsOfChart& flips,
                           Certificate* certificate, HalfPlaneChart* chart, bool* clean) {
  *clean = false;
  return ChartSolve(surface, options, control, flips, certificate, chart).Run(pole, clean);
}

}  // namespace cirque

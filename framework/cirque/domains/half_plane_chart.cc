#include "cirque/domains/half_plane_chart.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cirque/intrinsic/flip_complex.h"
#include "cirque/layout/half_plane.h"
#include "cirque/layout/planar_layout.h"
#include "cirque/mesh/holes.h"
#include "cirque/pipeline/flatten.h"

namespace cirque {
namespace {

constexpr int kMaxPoles = 3;  ///< that are tried where none is given

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

/// How far every edge is from Delaunay in the surface glued to its mirror image [rad].
std::vector<double> DelaunayExcess(const Triangulation& t, const CornerAngles& angles) {
  std::vector<double> excess(t.num_edges(), 0);
  for (Index h = 0; h < t.num_halfedges(); ++h) excess[t.edge[h]] += angles.value[h];
  for (Index e = 0; e < t.num_edges(); ++e) {
    excess[e] = std::max(0.0, excess[e] - (t.IsBoundaryEdge(e) ? 0.5 * kPi : kPi));
  }
  return excess;
}

class ChartSolve {
 public:
  ChartSolve(const ChartJob& job, const FlipsOfChart& flips, Certificate* certificate,
             HalfPlaneChart* chart, std::optional<SolvedChart>* first)
      : job_(job),
        t_(job.surface.triangulation),
        options_(job.options),
        flips_(flips),
        certificate_(*certificate),
        chart_(*chart),
        first_(*first) {}

  Status Run(bool* clean) {
    const Index pole = job_.pole;
    const std::vector<bool> core = LargestChordlessPiece(t_, job_.intrinsic.boundary);
    const std::vector<Index> ranked = RankPoles(job_.intrinsic);
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
    if (!proof_.empty()) NumberAsInFile(job_.surface, chart_.disk, &proof_);
    certificate_.infeasibility = std::move(proof_);
    return status;
  }

 private:
  Status SolveWithPole(const std::vector<bool>& core, Index pole, bool keep_star, bool* clean) {
    chart_ = {};
    first_.reset();
    chart_.disk = TakeOffStar(t_, job_.intrinsic.lengths, core, pole, options_.epsilon);
    if (chart_.disk.rest.face.empty()) return Status();
    if (keep_star) {
      KeepStar(t_, job_.intrinsic.angles, options_.epsilon, &chart_.disk);
    }
    return SolveWithLocks(clean);
  }

  Status SolveWithLocks(bool* clean) {
    const std::vector<bool> none(chart_.disk.rest.triangulation.num_edges(), false);
    const auto solve = [&](const std::vector<bool>& locked) -> StatusOr<std::vector<Index>> {
      if (Status s = Solve(options_, locked); !s.ok()) return s;
      std::vector<Index> flipped = flips_(chart_);
      *clean = flipped.empty();
      const bool locking_helps =
          options_.triangulation != SolvedTriangulation::kInput && chart_.increasing;
      return locking_helps ? std::move(flipped) : std::vector<Index>();
    };
    const auto flipped = SolveLockingFlipped(
        none, solve, [this](const std::vector<Index>& faces, std::vector<bool>* edges) {
          return LockEdgesOf(faces, edges);
        });
    if (!flipped.ok()) return flipped.status();
    return flipped->empty() ? Status() : SolveOnInput(clean);
  }

  /// The last resort; the chart stays what it was where that is no better.
  Status SolveOnInput(bool* clean) {
    const std::vector<bool> none(chart_.disk.rest.triangulation.num_edges(), false);
    ParameterizeOptions raw = options_;
    raw.triangulation = SolvedTriangulation::kInput;
    HalfPlaneChart before = chart_;
    const Status status = Solve(raw, none);
    if (status.ok()) *clean = flips_(chart_).empty();
    if (!*clean) chart_ = std::move(before);
    return status.code() == StatusCode::kCancelled ? status : Status();
  }

  /// False when there is no edge left to lock.
  bool LockEdgesOf(const std::vector<Index>& flipped, std::vector<bool>* locked) const {
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
    const IntrinsicSurface rest = MeasureSurface(t, disk.lengths);
    FlatSurface flat;
    Status status =
        Flatten({rest, disk.targets, options, job_.control, &locked}, &certificate_, &flat);
    proof_ = std::move(flat.infeasibility);
    if (!status.ok()) return status;
    Fill(&certificate_.layout).layout_closure =
        LayOut(t, flat.on_input.angles, flat.on_input.lengths, &chart_);
    if (!flat.exact || first_) return status;
    SolvedMetric& solved = *flat.exact;
    first_ = {chart_, std::move(solved.intrinsic)};
    first_->layout_closure =
        LayOut(first_->rest.triangulation, solved.angles, solved.lengths, &first_->chart);
    return status;
  }

  /// Puts a flat metric of the rest into the half-plane; returns the closure.
  double LayOut(const Triangulation& t, const CornerAngles& angles, const EdgeLengths& lengths,
                HalfPlaneChart* chart) const {
    const PuncturedDisk& disk = chart->disk;
    const PlanarLayout layout = LayOutByDirections(t, angles, lengths);
    const HalfPlane moved = MoveToHalfPlane(t, layout.uv, disk.chain);
    chart->chain_length = ChainLengths(t, lengths, disk.chain);
    chart->straightness = moved.straightness;
    chart->increasing = moved.increasing;
    chart->position.assign(t_.num_vertices, 0);
    for (Index v = 0; v < t.num_vertices; ++v) {
      chart->position[disk.rest.vertex[v]] = moved.position[v];
    }
    return layout.closure;
  }

  const ChartJob& job_;
  const Triangulation& t_;
  const ParameterizeOptions& options_;
  const FlipsOfChart& flips_;
  Certificate& certificate_;
  HalfPlaneChart& chart_;
  std::optional<SolvedChart>& first_;
  InfeasibilityCertificate proof_;  ///< of the last solve
};

}  // namespace

std::vector<Index> RankPoles(const IntrinsicSurface& whole) {
  const SubTriangulation part =
      KeepFaces(whole.triangulation, LargestChordlessPiece(whole.triangulation, whole.boundary));
  const Triangulation& t = part.triangulation;
  CornerAngles angles = {Eigen::VectorXd(t.num_halfedges())};
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    angles.value[h] = whole.angles.value[part.Halfedge(h)];
  }
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

IntrinsicTriangulation FlippedWhole(const Triangulation& disk, const EdgeLengths& lengths,
                                    const SolvedChart& solved) {
  const SubTriangulation& rest = solved.chart.disk.rest;
  FlipComplex complex(disk, lengths);
  std::vector<Index> flips;
  for (const Index h : solved.rest.flips) {
    flips.push_back(rest.Halfedge(h));
    complex.Flip(flips.back(), 0, kNone);
  }
  Triangulation t = complex.MakeTriangulation(disk.num_vertices);
  EdgeLengths own = complex.MakeLengths(t);
  for (Index h = 0; h < solved.rest.triangulation.num_halfedges(); ++h) {
    own.value[t.edge[rest.Halfedge(h)]] =
        solved.rest.lengths.value[solved.rest.triangulation.edge[h]];
  }
  return {std::move(t), std::move(own), std::move(flips), {}};
}

Status SolveHalfPlaneChart(const ChartJob& job, const FlipsOfChart& flips, Certificate* certificate,
                           HalfPlaneChart* chart, bool* clean, std::optional<SolvedChart>* first) {
  *clean = false;
  return ChartSolve(job, flips, certificate, chart, first).Run(clean);
}

}  // namespace cirque

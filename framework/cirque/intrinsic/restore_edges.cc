#include "cirque/intrinsic/restore_edges.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>

namespace cirque {
namespace {

/// Attempts at turning an edge, for each pair of those that a line crosses at first.
constexpr std::size_t kAttemptsPerPair = 20;

Index Next(Index h) { return Triangulation::Next(h); }
Index Prev(Index h) { return Triangulation::Prev(h); }

/// A line as it is found at a corner: the i-th input edge from there.
struct Line {
  Index corner = kNone;
  std::int64_t i = 0;
};

bool TurnEdge(Index h, FlipComplex* metric) {
  const std::optional<double> length = metric->OtherDiagonal(h);
  if (length) metric->Flip(h, *length, kNone);
  return length.has_value();
}

bool TurnEdge(Index h, TripleFlipComplex* metric) { return metric->Turn(h); }

template <class Metric>
class EdgeRestorer {
 public:
  EdgeRestorer(const Triangulation& input, const std::vector<bool>& edges,
               NormalCoordinates* normal, Metric* metric, std::vector<Index>* flips)
      : input_(input), edges_(edges), normal_(*normal), metric_(*metric), flips_(*flips) {}

  bool Run() {
    for (;;) {
      touched_.assign(input_.num_faces(), false);
      const std::vector<Line> lines = Missing();
      if (lines.empty()) return true;
      for (const Line& line : lines) {
        if (IsUntouched(line) && !Restore(line)) return false;
      }
    }
  }

 private:
  Index EdgeOf(const Line& line) const { return Prev(normal_.InputCorner(line.corner, line.i)); }

  /// The lines that are no edges, each where its halfedge begins.
  std::vector<Line> Missing() const {
    std::vector<Line> lines;
    for (Line line{0, 0}; line.corner < input_.num_halfedges(); ++line.corner) {
      for (line.i = 0; line.i < normal_.Emanating(line.corner); ++line.i) {
        const Index h = EdgeOf(line), e = input_.edge[h];
        if (edges_[e] && input_.edge_halfedge[e] == h) lines.push_back(line);
      }
    }
    return lines;
  }

  /// Whether it still is where it was when touched_ was cleared.
  bool IsUntouched(const Line& line) const {
    if (touched_[Triangulation::Face(line.corner)]) return false;
    const std::vector<Index> path = normal_.Crossed(line.corner, line.i);
    return std::none_of(path.begin(), path.end(), [&](Index h) {
      return touched_[Triangulation::Face(h)] || touched_[Triangulation::Face(metric_.twin(h))];
    });
  }

  /// Turns edges across the line: one that then crosses it no more, or else any. Which is drawn, so that
  /// symmetric surroundings do not turn to and fro for ever.
  bool Restore(const Line& line) {
    const Index edge = EdgeOf(line);
    std::vector<Index> path = normal_.Crossed(line.corner, line.i);
    std::vector<Index> corners = {Next(line.corner), line.corner, Prev(line.corner)};
    std::minstd_rand random;
    std::size_t left = kAttemptsPerPair * (path.size() + 1) * (path.size() + 1);
    for (; !path.empty() && left > 0; --left) {
      std::optional<Index> turned = TurnAway(path);
      if (!turned) {
        const Index h = path[random() % path.size()];
        if (!Turn(h)) continue;
        turned = h;
      }
      for (const Index side : {*turned, metric_.twin(*turned)}) {
        corners.insert(corners.end(), {Next(side), side, Prev(side)});
      }
      path = PathOf(edge, corners);
    }
    return path.empty();
  }

  /// Turns an edge that crosses the path no more then.
  std::optional<Index> TurnAway(const std::vector<Index>& path) {
    for (std::size_t i = 0; i < path.size(); ++i) {
      if (PartsFromDiagonal(path, i) && Turn(path[i])) return path[i];
    }
    return {};
  }

  /// What the input's halfedge crosses, which begins at one of the corners.
  std::vector<Index> PathOf(Index edge, const std::vector<Index>& corners) const {
    for (Line line; const Index corner : corners) {
      line.corner = corner;
      for (line.i = 0; line.i < normal_.Emanating(corner); ++line.i) {
        if (EdgeOf(line) == edge) return normal_.Crossed(corner, line.i);
      }
    }
    return {};
  }

  /// Whether the path does not cross the diagonal that would replace its i-th edge: it begins or
  /// ends at an apex there, or stays on one side of the two apexes.
  bool PartsFromDiagonal(const std::vector<Index>& path, std::size_t i) const {
    if (i == 0 || i + 1 == path.size()) return true;
    const bool from_tail_side = metric_.twin(path[i - 1]) == Prev(path[i]);
    const Index in = metric_.twin(path[i]);
    return from_tail_side == (path[i + 1] == Next(in));
  }

  bool Turn(Index h) {
    const Index g = metric_.twin(h), left = Triangulation::Face(h);
    if (g == kNone || Triangulation::Face(g) == left) return false;
    if (!TurnEdge(h, &metric_)) return false;
    normal_.Flip(h);
    flips_.push_back(h);
    touched_[left] = touched_[Triangulation::Face(g)] = true;
    return true;
  }

  const Triangulation& input_;
  const std::vector<bool>& edges_;
  NormalCoordinates& normal_;
  Metric& metric_;
  std::vector<Index>& flips_;
  std::vector<bool> touched_;  ///< faces, since the lines were looked for
};

}  // namespace

bool RestoreEdges(const Triangulation& input, const std::vector<bool>& edges,
                  NormalCoordinates* normal, FlipComplex* metric, std::vector<Index>* flips) {
  return EdgeRestorer(input, edges, normal, metric, flips).Run();
}

bool RestoreEdges(const Triangulation& input, const std::vector<bool>& edges,
                  NormalCoordinates* normal, TripleFlipComplex* metric, std::vector<Index>* flips) {
  return EdgeRestorer(input, edges, normal, metric, flips).Run();
}

}  // namespace cirque

#include "cirque/intrinsic/normal_coordinates.h"

#include <algorithm>

#include <Eigen/Core>
#include <glog/logging.h>

namespace cirque {
namespace {

Index Next(Index h) { return Triangulation::Next(h); }
Index Prev(Index h) { return Triangulation::Prev(h); }

/// The first corner behind the boundary at its vertex, or the corner itself inside.
Index FirstCorner(const Triangulation& t, Index corner) {
  Index c = corner;
  while (t.twin[Prev(c)] != kNone) {
    c = Prev(t.twin[Prev(c)]);
    if (c == corner) break;
  }
  return c;
}

EdgeLengths NoLengths(const Triangulation& t) { return {Eigen::VectorXd::Zero(t.num_edges())}; }

}  // namespace

EdgesAround SortEdgesAround(const Triangulation& t) {
  EdgesAround around;
  around.boundary = BoundaryVertices(t);
  around.first.assign(t.num_vertices + 1, 0);
  for (const Index v : t.vertex) ++around.first[v + 1];
  for (Index v = 0; v < t.num_vertices; ++v) around.first[v + 1] += around.first[v];
  around.corner.resize(t.num_halfedges());
  around.rank.assign(t.num_halfedges(), kNone);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (around.rank[h] != kNone) continue;
    Index rank = 0;
    t.ForEachCornerAround(FirstCorner(t, h), [&](Index corner) {
      around.corner[around.first[t.vertex[h]] + rank] = corner;
      around.rank[corner] = rank++;
    });
  }
  return around;
}

NormalCoordinates::NormalCoordinates(const Triangulation& input)
    : around_(SortEdgesAround(input)),
      complex_(input, NoLengths(input)),
      side_(input.num_halfedges()) {
  for (Index h = 0; h < input.num_halfedges(); ++h) side_[h].rank = around_.rank[Next(h)];
}

std::int64_t NormalCoordinates::Emanating(Index corner) const {
  return std::max<std::int64_t>(
      0, Crossings(corner) - Crossings(Next(corner)) - Crossings(Prev(corner)));
}

std::int64_t NormalCoordinates::Cutting(Index corner) const {
  const std::int64_t around = std::max<std::int64_t>(
      0, Crossings(Next(corner)) + Crossings(Prev(corner)) - Crossings(corner));
  return (around - Emanating(Next(corner)) - Emanating(Prev(corner))) / 2;
}

std::int64_t NormalCoordinates::Between(Index v, std::int64_t rank) const {
  if (around_.boundary[v]) return rank;
  const Index degree = around_.Degree(v);
  return ((rank % degree) + degree) % degree;
}

Index NormalCoordinates::InputCorner(Index corner, std::int64_t i) const {
  const Index v = complex_.vertex(corner), side = Prev(corner);
  const std::int64_t rank = Rank(side) + (IsShared(side) ? 1 : 0) + i;
  return around_.CornerAt(v, static_cast<Index>(Between(v, rank)));
}

Index NormalCoordinates::SharedHalfedge(Index h) const {
  const Index v = complex_.vertex(Next(h));
  return Prev(around_.CornerAt(v, side_[h].rank));
}

Index NormalCoordinates::Across(Index x, std::int64_t* at) const {
  const std::int64_t round_tail = Cutting(Next(x)), ending = Emanating(x);
  if (*at < round_tail) {
    *at = Crossings(Prev(x)) - 1 - *at;
    return Prev(x);
  }
  if (*at < round_tail + ending) return kNone;
  *at = Crossings(x) - 1 - *at;
  return Next(x);
}

std::vector<Index> NormalCoordinates::Crossed(Index corner, std::int64_t i) const {
  std::vector<Index> crossed;
  std::int64_t at = Cutting(Next(corner)) + i;
  for (Index out = corner; out != kNone; out = Across(complex_.twin(out), &at)) {
    crossed.push_back(out);
    at = Crossings(out) - 1 - at;
  }
  return crossed;
}

/// The edge i -> j of h, seen from i, is crossed on its left by a arcs that cut i, b from the apex
/// k and others that cut j; on its right by c that cut i, d from the apex l and others. Crossings
/// have the same order on both sides, which says what goes on where.
void NormalCoordinates::Flip(Index h) {
  const Index g = complex_.twin(h);
  CHECK(g != kNone && Triangulation::Face(g) != Triangulation::Face(h));
  const std::int64_t a = Cutting(Next(h)), b = Emanating(h);
  const std::int64_t c = Cutting(Prev(g)), d = Emanating(g);
  const std::int64_t zero = 0;
  Side left, right;  // of k -> l, which is g, and of l -> k
  left.shared = std::min(a + b, c + d) > std::max(a, c);
  left.crossings = Cutting(h) + Cutting(g) + Emanating(Next(h)) + Emanating(Prev(h)) +
                   Emanating(Next(g)) + Emanating(Prev(g)) + std::max(zero, a - c - d) +
                   std::max(zero, c - a - b) + (IsShared(h) ? 1 : 0);
  right = left;
  const auto rank_behind = [&](Index side, std::int64_t passed) {
    const std::int64_t rank = Rank(side) + (IsShared(side) ? 1 : 0) + passed;
    return static_cast<Index>(Between(complex_.vertex(Next(side)), rank));
  };
  left.rank = rank_behind(Prev(h), std::max(zero, std::min(a + b, c) - a));
  right.rank = rank_behind(Prev(g), std::max(zero, c + d - std::max(c, a + b)));
  const Side moved[4] = {side_[Next(h)], side_[Prev(h)], side_[Next(g)], side_[Prev(g)]};
  complex_.Flip(h, 0, kNone);
  side_[Prev(g)] = moved[0];
  side_[Next(h)] = moved[1];
  side_[Prev(h)] = moved[2];
  side_[Next(g)] = moved[3];
  side_[g] = left;
  side_[h] = right;
}

}  // namespace cirque

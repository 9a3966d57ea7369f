#include "cirque/intrinsic/flip_complex.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cirque {
namespace {

Index Next(Index h) { return Triangulation::Next(h); }
Index Prev(Index h) { return Triangulation::Prev(h); }

/// b + c - a, at least 0. The larger of b and c goes first: the difference to it is exact where
/// cancellation threatens (W. Kahan, "Miscalculating Area and Angles of a Needle-like Triangle").
double Excess(double a, double b, double c) {
  return std::max(b >= c ? c - (a - b) : b - (a - c), 0.0);
}

/// tan^2 of half the angle opposite a. Quotients of lengths only, so no scale overflows.
double SquaredHalfTangentOpposite(double a, double b, double c) {
  return (Excess(b, c, a) / (a + b + c)) * (Excess(c, a, b) / Excess(a, b, c));
}

bool HasArea(double a, double b, double c) {
  return Excess(a, b, c) > 0 && Excess(b, c, a) > 0 && Excess(c, a, b) > 0;
}

}  // namespace

FlipComplex::FlipComplex(const Triangulation& t, const EdgeLengths& lengths)
    : side_(t.vertex.size()) {
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    side_[h] = {lengths.value[t.edge[h]], t.vertex[h], t.twin[h], t.edge[h]};
  }
}

double FlipComplex::SquaredHalfTangent(Index h) const {
  return SquaredHalfTangentOpposite(side_[h].length, side_[Next(h)].length, side_[Prev(h)].length);
}

double FlipComplex::DelaunayRatio(Index h) const {
  return SquaredHalfTangent(h) * SquaredHalfTangent(side_[h].twin);
}

std::optional<double> FlipComplex::OtherDiagonal(Index h) const {
  const Index g = side_[h].twin;
  return OtherDiagonal(h, {SquaredHalfTangent(Next(h)), SquaredHalfTangent(Prev(g)),
                           SquaredHalfTangent(Prev(h)), SquaredHalfTangent(Next(g))});
}

std::optional<double> FlipComplex::OtherDiagonal(Index h, const EndTangents& tangents) const {
  const Index g = side_[h].twin;
  const auto [left, right, left_at_tip, right_at_tip] = tangents;
  // tan^2(x / 2) tan^2(y / 2) < 1 exactly when x + y < pi.
  const bool convex_at_tail = left * right < 1;
  const bool convex_at_tip = left_at_tip * right_at_tip < 1;
  if (!convex_at_tail || !convex_at_tip) return std::nullopt;
  // The law of cosines without a difference but that of two given lengths:
  // z^2 = (x - y)^2 + 4 x y sin^2(half the angle at the tail).
  const double x = side_[Prev(h)].length, y = side_[Next(g)].length;
  const double sine = (std::sqrt(left) + std::sqrt(right)) / std::sqrt((1 + left) * (1 + right));
  const double z = std::hypot(x - y, 2 * std::sqrt(x) * std::sqrt(y) * sine);
  const bool has_areas =
      HasArea(x, y, z) && HasArea(side_[Next(h)].length, side_[Prev(g)].length, z);
  if (!has_areas) return std::nullopt;
  return z;
}

std::array<double, 2> FlipComplex::TangentsAfterFlip(Index h, double length) const {
  const Index g = side_[h].twin;
  return {SquaredHalfTangentOpposite(length, side_[Prev(h)].length, side_[Next(g)].length),
          SquaredHalfTangentOpposite(length, side_[Prev(g)].length, side_[Next(h)].length)};
}

double FlipComplex::RatioAfterFlip(Index h, double length) const {
  const auto [of_h, of_twin] = TangentsAfterFlip(h, length);
  return of_h * of_twin;
}

/// Two of the moved sides may be glued to each other, so all are read before any is written.
void FlipComplex::MoveSides(const Index (&from)[4], const Index (&to)[4]) {
  Side moved[4];
  for (int i = 0; i < 4; ++i) moved[i] = side_[from[i]];
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      if (moved[i].twin == from[j]) {
        moved[i].twin = to[j];
        break;
      }
    }
  }
  for (int i = 0; i < 4; ++i) {
    side_[to[i]] = moved[i];
    if (moved[i].twin != kNone) side_[moved[i].twin].twin = to[i];
  }
}

void FlipComplex::SetEdge(Index h, double length, Index label) {
  for (const Index side : {h, side_[h].twin}) {
    side_[side].length = length;
    side_[side].label = label;
  }
}

void FlipComplex::Flip(Index h, double length, Index label) {
  const Index g = side_[h].twin;
  const Index a = vertex(Next(h)), b = vertex(Prev(h)), c = vertex(h), d = vertex(g);
  MoveSides({Next(h), Prev(h), Next(g), Prev(g)}, {Prev(g), Next(h), Prev(h), Next(g)});
  SetEdge(h, length, label);
  side_[h].vertex = a;
  side_[Next(h)].vertex = side_[Prev(g)].vertex = d;
  side_[Prev(h)].vertex = side_[Next(g)].vertex = c;
  side_[g].vertex = b;
}

void FlipComplex::Unflip(Index h, double length, Index label) {
  const Index g = side_[h].twin;
  const Index a = vertex(h), b = vertex(g), c = vertex(Prev(h)), d = vertex(Next(h));
  MoveSides({Prev(g), Next(h), Prev(h), Next(g)}, {Next(h), Prev(h), Next(g), Prev(g)});
  SetEdge(h, length, label);
  side_[h].vertex = c;
  side_[Next(h)].vertex = side_[Prev(g)].vertex = a;
  side_[Prev(h)].vertex = side_[Next(g)].vertex = b;
  side_[g].vertex = d;
}

Triangulation FlipComplex::MakeTriangulation(Index num_vertices) const {
  std::vector<Index> vertex, twin;
  vertex.reserve(side_.size());
  twin.reserve(side_.size());
  for (const Side& side : side_) {
    vertex.push_back(side.vertex);
    twin.push_back(side.twin);
  }
  return NumberEdges(num_vertices, std::move(vertex), std::move(twin));
}

EdgeLengths FlipComplex::MakeLengths(const Triangulation& t) const {
  EdgeLengths lengths;
  lengths.value.resize(t.num_edges());
  for (Index e = 0; e < t.num_edges(); ++e) lengths.value[e] = side_[t.edge_halfedge[e]].length;
  return lengths;
}

}  // namespace cirque

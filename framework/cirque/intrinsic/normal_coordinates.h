#pragma once

#include <cstdint>
#include <vector>

#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/flip_complex.h"

namespace cirque {

/// The edges at every vertex of a triangulation, counter-clockwise: each is known by the corner
/// that follows it, whose edge Prev(corner) is. At a vertex on the boundary the first corner is
/// the one behind the boundary, and the last edge, which no corner follows, is on the boundary too.
struct EdgesAround {
  std::vector<Index> first;   ///< V + 1: corners of vertex v are [first[v], first[v + 1])
  std::vector<Index> corner;  ///< 3F
  std::vector<Index> rank;    ///< 3F: of a corner among those of its vertex
  std::vector<bool> boundary;

  Index Degree(Index v) const { return first[v + 1] - first[v]; }
  Index CornerAt(Index v, Index at) const { return corner[first[v] + at]; }
};

EdgesAround SortEdgesAround(const Triangulation& triangulation);

/// Where the edges of an input triangulation run on another one with the same vertices while the
/// other is flipped: by integers alone, so exactly, also where faces are glued to themselves and
/// where two vertices share several edges.
///   n_e   the number of times that input edges cross edge e; where the edge is one of the input's
///         it is shared: n_e = 0, and nothing crosses it
///   r_h   for halfedge h from v: the rank of the first input edge at v that is h or, going
///         counter-clockwise, behind it
/// A face with n = (n_ij, n_jk, n_ki) is crossed by
///   c_i = (max(0, n_ij + n_ki - n_jk) - e_j - e_k) / 2   arcs round corner i, and by
///   e_i = max(0, n_jk - n_ij - n_ki)                     arcs from corner i to the side
/// opposite; of e_i, e_j, e_k one at most is not 0. Source: M. Gillespie, N. Sharp, K. Crane,
/// "Integer Coordinates for Intrinsic Geometry Processing", 2021 (with n = -1 for shared edges).
class NormalCoordinates {
 public:
  /// All edges are shared.
  explicit NormalCoordinates(const Triangulation& input);

  /// FlipComplex::Flip of h. An interior edge between two different faces.
  void Flip(Index h);

  const EdgesAround& around() const { return around_; }
  const FlipComplex& complex() const { return complex_; }

  std::int64_t Crossings(Index h) const { return side_[h].crossings; }  ///< n of its edge
  bool IsShared(Index h) const { return side_[h].shared; }
  Index Rank(Index h) const { return side_[h].rank; }  ///< r

  std::int64_t Cutting(Index corner) const;    ///< c
  std::int64_t Emanating(Index corner) const;  ///< e

  /// The corner of the input that follows the `i`-th input edge, counted from 0, that leaves this
  /// corner for the opposite side; with i = -1 the last input edge before them: that of the side
  /// Prev(corner), or one outside. At i = -1 this is the corner that holds what lies before the
  /// first.
  Index InputCorner(Index corner, std::int64_t i) const;

  /// The input's halfedge along a shared halfedge that has a face.
  Index SharedHalfedge(Index h) const;

  /// Where an input edge goes on that enters a face by halfedge x, `*at` crossings behind its tail:
  /// the halfedge that it leaves by, with the place there in `*at`; kNone where it ends at the
  /// vertex opposite.
  Index Across(Index x, std::int64_t* at) const;

  /// The halfedges that the `i`-th input edge from the corner crosses, each of the face that it
  /// leaves, in order.
  std::vector<Index> Crossed(Index corner, std::int64_t i) const;

 private:
  struct Side {
    std::int64_t crossings = 0;
    Index rank = 0;
    bool shared = true;
  };

  std::int64_t Between(Index v, std::int64_t rank) const;

  EdgesAround around_;
  FlipComplex complex_;  // without lengths
  std::vector<Side> side_;
};

}  // namespace cirque

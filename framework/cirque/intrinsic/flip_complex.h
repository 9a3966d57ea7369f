#pragma once

#include <array>
#include <optional>
#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// A Delta-complex with edge lengths while its edges are flipped. A flip reuses the slots of its
/// two faces: the edge keeps its halfedges h and twin(h), the four other sides move on by one slot,
/// so that undoing the flips in reverse order brings back the very same arrays.
class FlipComplex {
 public:
  /// Numbers every edge's label by the edge.
  FlipComplex(const Triangulation& triangulation, const EdgeLengths& lengths);

  Index num_halfedges() const { return static_cast<Index>(side_.size()); }
  Index vertex(Index h) const { return side_[h].vertex; }  ///< at the corner opposite h
  Index twin(Index h) const { return side_[h].twin; }
  Index label(Index h) const { return side_[h].label; }
  double length(Index h) const { return side_[h].length; }  ///< of its edge

  /// tan^2 of half the corner angle opposite h: 0 .. infinity.
  double SquaredHalfTangent(Index h) const;

  /// tan^2(alpha_l / 2) tan^2(alpha_r / 2) of the angles opposite the edge of h: above 1 exactly
  /// when they add up to more than pi. An interior edge.
  double DelaunayRatio(Index h) const;

  /// SquaredHalfTangent at the four corners that the edge of h ends in: at its tail on the left and
  /// on the right of h, then at its tip.
  using EndTangents = std::array<double, 4>;

  /// The length of the other diagonal of the two faces at h, unfolded into the plane; nothing where
  /// it lies outside them or one of the new faces would have no area. An interior edge between two
  /// different faces. Whoever knows the corners' half tangents passes them.
  std::optional<double> OtherDiagonal(Index h) const;
  std::optional<double> OtherDiagonal(Index h, const EndTangents& tangents) const;

  /// What SquaredHalfTangent would be of h and of its twin, were the edge of h flipped to the other
  /// diagonal, of that length.
  std::array<double, 2> TangentsAfterFlip(Index h, double length) const;

  /// DelaunayRatio of the other diagonal, likewise: their product.
  double RatioAfterFlip(Index h, double length) const;

  /// Turns the edge of h counter-clockwise: from a -> b with the apexes c on its left and d on its
  /// right to d -> c, with a on its left.
  void Flip(Index h, double length, Index label);

  /// The inverse of Flip: turns it clockwise.
  void Unflip(Index h, double length, Index label);

  /// The complex as it stands, edges numbered afresh.
  Triangulation MakeTriangulation(Index num_vertices) const;
  EdgeLengths MakeLengths(const Triangulation& triangulation) const;

 private:
  struct Side {
    double length;
    Index vertex, twin, label;
  };

  void MoveSides(const Index (&from)[4], const Index (&to)[4]);
  void SetEdge(Index h, double length, Index label);

  std::vector<Side> side_;
};

}  // namespace cirque

#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// A point where an edge of the input crosses one of the other triangulation. Both are told by a
/// halfedge, and the position along it as a fraction of its length from its tail, strictly between
/// 0 and 1. Halfedges are those of edges (Triangulation::edge_halfedge).
struct Crossing {
  Index input = kNone, other = kNone;
  double along_input = 0, along_other = 0;
  double log_weight = 0;  ///< of conformal equivalence (ideal_geodesic.h); else 0
};

/// One input edge on its way over the other triangulation: it leaves the vertex at `corner` through
/// the side opposite and crosses edges, each here as the halfedge of the face that it leaves.
struct EdgePath {
  Index corner;
  std::span<const Index> crossed;
  Index input = kNone;  ///< the input's halfedge
};

/// Where an input edge meets the edges that it crosses, in order: fractions along the input edge
/// and along every halfedge crossed. `log_weight`: as in Crossing; empty: none.
struct PathPositions {
  std::vector<double> along_input, along_crossed, log_weight = {};
};

/// A rule for the positions: the metrics decide what is straight (StraightLines,
/// IdealGeodesics).
using PositionRule = std::function<PathPositions(const EdgePath&)>;

/// The common refinement of two triangulations of a surface with the same vertices, an input and
/// another one that it was flipped to: every face is the part of one face of the input that lies in
/// one face of the other, a convex polygon of 3 to 6 sides on both. Its vertices are the common
/// ones, 0 to V - 1, and from V on the crossings; no vertex lies inside an edge of it.
struct Overlay {
  /// A corner of a face: where its vertex is in the face of the input and in the face of the other
  /// one. Of a common vertex: the corner there; of a crossing: the halfedge of that face.
  struct Corner {
    Index vertex, input, other;
  };

  Index num_vertices = 0;  ///< V
  std::vector<Crossing> crossing;
  std::vector<Index> first_corner;  ///< faces + 1: face p owns corners [p], [p + 1]
  std::vector<Corner> corner;       ///< counter-clockwise
  std::vector<Index> input_face;    ///< of every face
  std::vector<Index> other_face;

  Index num_faces() const { return static_cast<Index>(input_face.size()); }
};

/// The overlay of `input` and what its `flips` lead to: halfedges as FlipComplex::Flip takes them,
/// in order (IntrinsicTriangulation::flips). The combinatorics are exact (NormalCoordinates).
/// Positions are those of the rule, but crossings along an edge keep their order, and at least
/// kCrossingSeparation between each other and from the edge's ends (Separate).
/// Error (invalid input): it would have more than `most_faces` faces; nothing is made then.
StatusOr<Overlay> MakeOverlay(const Triangulation& input, const std::vector<Index>& flips,
                              const PositionRule& rule, std::int64_t most_faces);

/// Makes fractions increasing that were so but for rounding: at least `separation` apart, and from
/// 0 and 1, or 1 / (n + 1) where n of them would not fit.
void Separate(double separation, std::vector<double>* fractions);

/// The separation of crossings along an edge, as a fraction of its length. Points in strictly
/// increasing order along the sides of a triangle cut it into convex polygons of positive area,
/// wherever they are: so no face of an overlay is lost to rounding.
inline constexpr double kCrossingSeparation = 1e-12;

}  // namespace cirque

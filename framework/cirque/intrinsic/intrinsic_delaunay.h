#pragma once

#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/intrinsic_surface.h"

namespace cirque {

/// Which inner edges between boundary vertices a topological disk with prescribed angle sums can
/// have. Such a chord cuts the disk in two; in either part Gauss-Bonnet leaves the chord's two ends
///   theta_u + theta_w = sum over the vertices between them along the boundary of (pi - Theta_i)
///                     + sum over the part's inner vertices of (2 pi - Theta_i),
/// which must be positive: beyond a chord along a straight boundary there is no room for a
/// triangle, nor beyond one that joins neighbours on the boundary. (From a vertex to itself: one
/// angle, and pi less.) Cones may lie in either part, which the guard does not find out.
class ChordGuard {
 public:
  /// Guards nothing where `triangulation` is no topological disk: an edge between boundary vertices
  /// need not cut other surfaces in two.
  ChordGuard(const Triangulation& triangulation, const ConeTargets& targets);

  /// False for an edge whose ends lie on the boundary and that no angles within the targets allow
  /// (with 1 % of pi to spare).
  bool Allows(Index u, Index w) const;

 private:
  std::vector<std::size_t> position_;  ///< per vertex on the boundary loop; kInside: none
  double cone_curvature_ = 0;          ///< the most that inner vertices can have in all
  std::vector<double> turned_;  ///< sum of pi - lower over the loop's vertices before a position
};

/// Another triangulation of the same intrinsic metric with the same vertices, reached from an input
/// triangulation by edge flips. Faces and halfedges keep the input's slots: face f of the one is
/// not face f of the other, yet undoing the flips in reverse order restores the input's arrays.
struct IntrinsicTriangulation {
  Triangulation triangulation;
  EdgeLengths lengths;
  /// The flips in order: the halfedge that was turned counter-clockwise (FlipComplex::Flip), in the
  /// numbering that holds before, during and after.
  std::vector<Index> flips;
  /// For every edge of the input the edge of `triangulation` that it still is, kNone when it was
  /// flipped away.
  std::vector<Index> edge_of_input;
};

/// What flips may not do.
struct IntrinsicDelaunayOptions {
  /// No flip leaves a vertex with fewer corners than its target needs (Theta_v < corners * pi), makes
  /// neighbours of two inner vertices of three corners each whose targets leave nothing of their
  /// four faces' angles to the two vertices round them (both flat: 4 pi of 4 pi), or makes a chord
  /// beyond which the targets leave no room (ChordGuard). Where a jagged boundary (0.25 rad off on
  /// average) is to be straight its vertices keep one corner more: where several in a row have two,
  /// their triangles meet at one apex, every angle on the boundary fixes the next, and the angle fit
  /// takes hundreds of steps. Null: interior vertices flat, boundary vertices free
  /// (FreeBoundaryTargets). The solve on the result then takes them through TransferTargets.
  const ConeTargets* targets = nullptr;
  /// Per edge of the input whether it must stay; empty: none must.
  std::vector<bool> locked;
};

/// Flips edges until every edge is Delaunay (the opposite angles add up to at most pi) or must not
/// be flipped: locked, of a vertex at its least number of corners (interior and flat: 3, boundary
/// and free: 1), into a chord without room, or with the same face on both sides. Works on the
/// lengths alone (A. Bobenko, B. Springborn, "A discrete Laplace-Beltrami operator for simplicial
/// surfaces", 2007; M. Fisher et al., "An algorithm for the construction of intrinsic Delaunay
/// triangulations", 2007).
///
/// Ends always: an edge that rounding cannot tell from Delaunay stays (kDelaunayTolerance), and so
/// does one whose other diagonal is not better; flips are bounded by 100 per edge.
/// Lengths must be positive and satisfy the triangle inequality.
IntrinsicTriangulation MakeIntrinsicDelaunay(const Triangulation& triangulation,
                                             const EdgeLengths& lengths,
                                             const IntrinsicDelaunayOptions& options = {});

/// Targets of `input` for another triangulation of the same vertices. Flips change the numbers of
/// corners, and with them the interval [0, pi * corners] that leaves a vertex free: free vertices
/// stay free, every other interval stays as it is.
ConeTargets TransferTargets(const IntrinsicSurface& input, const ConeTargets& targets,
                            const IntrinsicSurface& other);

/// tan^2(alpha_l / 2) tan^2(alpha_r / 2) may exceed 1 by this much.
inline constexpr double kDelaunayTolerance = 1e-10;

/// The interior edges that are not Delaunay, in increasing order.
std::vector<Index> NonDelaunayEdges(const Triangulation& triangulation, const EdgeLengths& lengths);

}  // namespace cirque

#pragma once

#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"

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
  std::vector<std::size_t> place_;  ///< per vertex on the boundary loop; kInside: none
  double cone_curvature_ = 0;       ///< the most that inner vertices can have in all
  std::vector<double> turned_;      ///< sum of pi - lower over the loop's vertices before a place
};

}  // namespace cirque

#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// A path from face to face: by which halfedge each face is entered, in order. Where the path is
/// closed the last face leads to the first; else `exit` is the halfedge by which the last is left.
struct DualPath {
  std::vector<Index> entered;
  Index exit = kNone;

  bool IsClosed() const { return exit == kNone; }
};

/// Loops around the handles, two each, from which every closed loop is made up, but for loops
/// around vertices and boundary loops: tree and cotree (D. Eppstein, "Dynamic generators of
/// topologically embedded graphs", SODA 2003; J. Erickson, K. Whittlesey, "Greedy optimal homotopy
/// and homology generators", SODA 2005). A breadth-first tree of the faces, a maximum spanning tree
/// of the other edges by the number of faces on the loop that each closes, boundary loops
/// contracted, and the loops that the 2 g edges in neither close. O(E log E).
std::vector<DualPath> HandleLoops(const Triangulation& triangulation);

/// Shortest paths of faces from the first boundary loop's first edge to that of every other one of
/// the same piece, in their order; a piece with fewer than two boundary loops has none.
std::vector<DualPath> BoundaryPaths(const Triangulation& triangulation);

/// The corners that a path passes, with their signs. Entering a face by h and leaving it by next(h)
/// turns right around the corner between them, by prev(h) left.
using SignedCorners = std::vector<std::pair<Index, int>>;

/// Those of a path. @pre no face is left as it was entered.
SignedCorners CornersAlong(const Triangulation& triangulation, const DualPath& path);

/// By what directions turn along the path: sum of sign * angle [rad]. Carried along a closed loop
/// of a flat metric, the direction of an edge comes back turned by this, modulo 2 pi; at the end of
/// an open path the direction of the edge that it leaves by, seen from behind it, is that of the
/// edge that it came in by, turned by this.
double RotationAlong(const SignedCorners& corners, const Eigen::VectorXd& angles);

/// By what directions turn around a boundary loop (its halfedges, as of BoundaryLoops), the surface
/// on the left: sum over its vertices of pi - Theta [rad].
double RotationAround(const Triangulation& triangulation, const std::vector<Index>& loop,
                      const std::vector<double>& angle_sums);

/// x minus the nearest multiple of `unit`.
double BeyondMultiple(double x, double unit);

}  // namespace cirque

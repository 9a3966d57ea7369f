#pragma once

#include <utility>
#include <vector>

#include "cirque/core/types.h"

namespace cirque {

/// How triangles on numbered vertices meet along their edges, before they are oriented. Halfedge
/// h = 3 f + k is the edge of triangle f opposite its corner k.
struct Gluing {
  std::vector<Index> mate;  ///< 3F: the halfedge on the other side, kNone on the boundary and where
                            ///< more than two triangles meet
  std::vector<std::pair<Index, Index>> non_manifold_edges;  ///< with more than two triangles
  std::vector<bool> on_boundary;  ///< 3F: the edge belongs to this triangle alone
  Index num_edges = 0;
};

/// Pairs the halfedges that join the same two vertices; those that have a `mate` already (diagonals
/// of polygons) keep it. `triangles` holds three different vertices a triangle. O(F + V).
Gluing GlueEdges(const std::vector<Index>& triangles, Index num_vertices, std::vector<Index> mate);

/// The corners about each vertex, apart where the vertex is not manifold: for every corner the
/// least corner that it is joined to by crossing glued edges at its vertex.
std::vector<Index> CornerFans(const std::vector<Index>& triangles, const Gluing& gluing);

/// The number of closed curves that the boundary edges form, passing from one to the next within a
/// fan of corners. Needs no orientation.
Index CountBoundaryLoops(const std::vector<Index>& fan, const Gluing& gluing);

}  // namespace cirque

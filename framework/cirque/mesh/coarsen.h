#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "cirque/core/types.h"
#include "cirque/io/polygon_soup.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// Collapses of edges, in order: each takes a vertex away and lets its faces end at the vertex that
/// the edge led to, but for those at the edge, which vanish. No vertex moves. Vertices and faces are
/// numbered as before them all, and corners of a face stay in their places.
struct CollapseLog {
  std::vector<Index> removed;
  std::vector<Index> kept;                    ///< where the edge led to
  std::vector<std::size_t> first_face = {0};  ///< one more than vertices removed
  /// The faces around each, counter-clockwise. Of an inner vertex the first and the last are those
  /// that vanish, of one on the boundary either the first or the last.
  std::vector<Index> face;
  /// Of every face, vanished ones as they were then.
  std::vector<std::array<Index, 3>> corner;

  std::size_t size() const { return removed.size(); }
};

/// A surface of fewer triangles, and the way back.
struct CoarseSurface {
  PolygonSoup soup;
  std::vector<Index> vertex;  ///< of each vertex of `soup`, which one of the surface it is
  std::vector<Index> face;    ///< of each triangle of `soup`, likewise
  CollapseLog collapses;
};

/// Collapses edges until about `faces` triangles are left, or none can be collapsed: the topology
/// stays, boundary vertices go along the boundary only, and triangles neither turn over nor become
/// thin. Vertices go evenly, in rounds of such as are no neighbours, each along the edge that leaves
/// the thickest, least turned triangles. So surfaces of any size are coarsened in linear time, to
/// the density that they had; error quadrics keep the shape better, and take a queue of all edges.
CoarseSurface Coarsen(const Surface& surface, Index faces);

}  // namespace cirque

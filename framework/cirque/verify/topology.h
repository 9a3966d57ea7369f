#pragma once

#include <vector>

#include "cirque/core/status.h"
#include "cirque/core/types.h"
#include "cirque/io/polygon_soup.h"

namespace cirque::verify {

/// The triangles of a mesh file, polygons cut into fans (0, i, i + 1). Halfedge h = 3 f + k runs
/// from corner k of triangle f to corner k + 1 (mod 3).
struct FanMesh {
  Index num_vertices = 0;
  std::vector<Index> vertex;       ///< 3F: the vertex at corner h, where halfedge h begins
  std::vector<Index> soup_corner;  ///< 3F: the polygon corner it comes from

  Index num_triangles() const { return static_cast<Index>(vertex.size() / 3); }

  static Index Next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index Prev(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
  Index Tail(Index h) const { return vertex[h]; }
  Index Tip(Index h) const { return vertex[Next(h)]; }
};

/// Errors: a polygon of fewer than three corners, a corner whose vertex does not exist.
StatusOr<FanMesh> FanTriangulate(const PolygonSoup& soup);

/// For every halfedge the one on the other side of its edge, in whichever direction it runs, or
/// kNone at the boundary. Errors: a triangle with a repeated vertex, an edge of three triangles or
/// more.
StatusOr<std::vector<Index>> PairHalfedges(const FanMesh& mesh);

/// Turns triangles (exchanging two corners) until neighbours agree, in every component as few as
/// possible, and returns which. Error: a surface that cannot be oriented.
StatusOr<std::vector<Index>> OrientConsistently(const std::vector<Index>& twin, FanMesh* mesh);

/// Error: a vertex at which several fans of triangles meet. The mesh must be oriented.
Status CheckOneFanPerVertex(const FanMesh& mesh, const std::vector<Index>& twin);

/// An oriented manifold triangle mesh.
struct Surface {
  FanMesh mesh;
  std::vector<Index> twin;
  std::vector<Index> turned;  ///< the triangles that had to be turned for it
};

/// All of the above.
StatusOr<Surface> BuildSurface(FanMesh mesh);

}  // namespace cirque::verify

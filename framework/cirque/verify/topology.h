#pragma once

#include <functional>
#include <vector>

#include "cirque/core/status.h"
#include "cirque/core/types.h"
#include "cirque/io/polygon_soup.h"

namespace cirque::verify {

/// The faces of a mesh file, cut into triangles. Halfedge h = 3 f + k runs from corner k of triangle
/// f to corner k + 1 (mod 3).
struct TriangleMesh {
  Index num_vertices = 0;
  std::vector<Index> vertex;       ///< 3F: the vertex at corner h, where halfedge h begins
  std::vector<Index> soup_corner;  ///< 3F: the polygon corner it comes from
  std::vector<Index> face;         ///< F: the face of the file that it is a part of
  std::vector<Index> place;        ///< 3F: the corner's number among the corners of its face
  /// 3F: whether the halfedge lies inside its face. The other side of it does too: two faces may
  /// have diagonals, or a diagonal and an edge, between the same vertices.
  std::vector<char> diagonal;
  /// V: the file's vertex, where several may be one of the file; empty: they are the file's.
  std::vector<Index> origin = {};

  Index num_triangles() const { return static_cast<Index>(vertex.size() / 3); }

  static Index Next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index Prev(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
  Index Tail(Index h) const { return vertex[h]; }
  Index Tip(Index h) const { return vertex[Next(h)]; }
  Index Origin(Index v) const { return origin.empty() ? v : origin[v]; }
};

/// Errors: a polygon of fewer than three corners, a corner whose vertex does not exist.
Status CheckFaces(const PolygonSoup& soup);

/// The same, and every polygon cut into the fan (0, i, i + 1), or where it has a vertex twice into
/// triangles that do not, if there are such. What is found on it may be said of how faces hang
/// together; where a polygon lies takes triangles that stay inside it (polygon_check.h). `keep`,
/// unless null, tells the faces to take.
StatusOr<TriangleMesh> FanTriangulate(const PolygonSoup& soup,
                                      const std::vector<bool>* keep = nullptr);

/// A corner of a face or of a piece of one.
struct FaceCorner {
  Index vertex, soup_corner;
  int place;  ///< among the corners of the face
};

/// Adds triangles, three numbers of `corners` each, as parts of a face that has as many corners in
/// all. Only their edges from one corner of the face to the next are no diagonals.
void AddTriangles(Index face, int num_corners, const std::vector<FaceCorner>& corners,
                  const std::vector<int>& triangles, TriangleMesh* mesh);

/// The face's corners, in the order of `corners`, without those that repeat the vertex and the place
/// in the plane (as `same` says) of the one before; their places are then counted anew.
void DropRepeatedCorners(const std::function<bool(const FaceCorner&, const FaceCorner&)>& same,
                         std::vector<FaceCorner>* corners);

/// What becomes of edges of three faces or more, and of vertices at which several fans of faces meet.
enum class Joints {
  kRefuse,  ///< errors
  kOpen     ///< such edges are boundary, and each fan has a vertex of its own
};

/// For every halfedge the one on the other side of its edge, in whichever direction it runs, or
/// kNone at the boundary. Errors: a triangle with a repeated vertex, an edge of three faces or more.
StatusOr<std::vector<Index>> PairHalfedges(const TriangleMesh& mesh,
                                           Joints joints = Joints::kRefuse);

/// Turns triangles (exchanging two corners) until neighbours agree, in every component as few as
/// possible, and returns which. Error: a surface that cannot be oriented.
StatusOr<std::vector<Index>> OrientConsistently(const std::vector<Index>& twin, TriangleMesh* mesh);

/// Error: a vertex at which several fans of faces meet. The mesh must be oriented.
Status CheckOneFanPerVertex(const TriangleMesh& mesh, const std::vector<Index>& twin);

/// Gives every fan of triangles a vertex of its own, the first that number. The mesh must be
/// oriented.
void SplitFans(const std::vector<Index>& twin, TriangleMesh* mesh);

/// An oriented manifold triangle mesh.
struct Surface {
  TriangleMesh mesh;
  std::vector<Index> twin;
  std::vector<Index> turned;  ///< the triangles that had to be turned for it
};

/// All of the above. With kOpen sides of an opened edge whose ends are still the same two vertices
/// once fans are apart, and no third side's, meet again.
StatusOr<Surface> BuildSurface(TriangleMesh mesh, Joints joints = Joints::kRefuse);

}  // namespace cirque::verify

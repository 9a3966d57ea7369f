#pragma once

#include <vector>

#include "cirque/verify/topology.h"
#include "cirque/verify/uv_plane.h"

namespace cirque::verify {

/// The triangles in the UV plane, glued where neighbours have the same UVs (compared by value, so a
/// file may number its `vt` as it likes). Edges of the mesh that are not glued are seams.
struct UvComplex {
  Surface surface;
  std::vector<Point> uv;       ///< 3F: at corner h
  std::vector<Index> uv_twin;  ///< 3F: as surface.twin, but kNone on seams too
  std::vector<Index> patch;    ///< F: the glued piece a triangle belongs to
  Index num_patches = 0;
  Index num_components = 0;  ///< pieces of the surface itself
  Index num_seam_edges = 0;

  /// Whether seams cut a piece of the surface apart, and not only open.
  bool torn() const { return num_patches > num_components; }
  const TriangleMesh& mesh() const { return surface.mesh; }
  Index num_triangles() const { return mesh().num_triangles(); }
  /// The face of IN that holds a halfedge.
  Index FaceOf(Index h) const { return mesh().face[h / 3]; }
  bool IsSeam(Index h) const { return uv_twin[h] == kNone && surface.twin[h] != kNone; }
  const Point& Tail(Index h) const { return uv[h]; }
  const Point& Tip(Index h) const { return uv[TriangleMesh::Next(h)]; }
};

/// Glues the triangles of `surface`, `uv` being in the order of its corners.
UvComplex BuildUvComplex(Surface surface, std::vector<Point> uv);

}  // namespace cirque::verify

#pragma once

#include <vector>

#include "experiments/verify_map/exact.h"
#include "experiments/verify_map/topology.h"

namespace cirque::verify_map {

/// The triangles in the UV plane, glued where neighbours have the same UVs (compared by value, so a
/// file may number its `vt` as it likes). Edges of the mesh that are not glued are seams.
struct UvComplex {
  Surface surface;
  std::vector<Point> uv;       ///< 3F: at corner h
  std::vector<Index> uv_twin;  ///< 3F: as surface.twin, but kNone on seams too
  std::vector<Index> patch;    ///< F: the glued piece a triangle belongs to
  Index num_patches = 0;

  const FanMesh& mesh() const { return surface.mesh; }
  Index num_triangles() const { return mesh().num_triangles(); }
  bool IsSeam(Index h) const { return uv_twin[h] == kNone && surface.twin[h] != kNone; }
  const Point& Tail(Index h) const { return uv[h]; }
  const Point& Tip(Index h) const { return uv[FanMesh::Next(h)]; }
};

/// Glues the triangles of `surface`, `uv` being in the order of its corners.
UvComplex BuildUvComplex(Surface surface, std::vector<Point> uv);

/// Exact orientation of every UV triangle, as ids.
struct Orientations {
  std::vector<Index> flipped;    ///< clockwise
  std::vector<Index> zero_area;  ///< three collinear points
};
Orientations ClassifyTriangles(const UvComplex& complex);

}  // namespace cirque::verify_map

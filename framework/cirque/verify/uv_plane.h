#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/verify/topology.h"

namespace cirque::verify {

/// A point of the UV plane. Its two doubles are taken to mean exactly what they say.
using Point = Eigen::Vector2d;

/// Sign of the signed area of the triangle a b c: +1 counterclockwise, 0 collinear, -1 clockwise.
/// Exact for all finite doubles: floating point where its error bound decides (Shewchuk 1997, the
/// first stage of orient2d), rational arithmetic where not.
int Orientation(const Point& a, const Point& b, const Point& c);

/// Whether p lies strictly between a and b on their segment, exactly.
bool OnOpenSegment(const Point& p, const Point& a, const Point& b);

/// Whether a and b (both other than apex) lie on one ray from apex, exactly.
bool OnSameRay(const Point& apex, const Point& a, const Point& b);

/// The part of a neighbourhood of `apex` swept counterclockwise from the ray towards `from` to the
/// ray towards `to`, without these rays. Equal rays mean the full turn, not the empty one.
struct Sector {
  Point apex, from, to;
};

/// Whether the ray from the sector's apex to p (other than the apex) runs inside the sector.
bool Contains(const Sector& sector, const Point& p);

/// Whether two sectors with one apex have an open set in common.
bool Overlap(const Sector& a, const Sector& b);

/// Whether the directed segment a b crosses the ray from the triangle's centroid towards +x: +1
/// upwards, -1 downwards, 0 not. Exact. Summed over closed curves that avoid the centroid this is
/// their winding number about it.
int RayCrossing(const Point (&triangle)[3], const Point& a, const Point& b);

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

}  // namespace cirque::verify

#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"
#include "cirque/io/polygon_soup.h"

namespace cirque {

/// A connected, oriented, manifold triangulated surface in space, with the way back to the file it
/// came from.
struct Surface {
  Triangulation triangulation;
  std::vector<Eigen::Vector3d> position;  ///< V
  /// V: the vertex's number in the soup. They differ by vertices of no face; several vertices of the
  /// surface may be one of the soup.
  std::vector<Index> soup_vertex;
  /// F: the polygon that the face is a part of; faces keep the soup's order.
  std::vector<Index> soup_polygon;
  /// 3F: the polygon corner (of PolygonSoup::corner) that each triangle's corner is.
  std::vector<Index> soup_corner;
};

/// The Euclidean length of every edge (E), without underflow or overflow.
EdgeLengths MeasureEdgeLengths(const Surface& surface);

/// Measures the angles (3F [rad]) of needles anew, triangles with a corner below 1e-6: edge lengths
/// tell angles to the root of rounding only, points to rounding.
void MeasureNeedles(const Surface& surface, CornerAngles* angles);

/// Per edge (E) whether it lies inside a polygon of the input, which is cut along it into triangles:
/// on both sides of it are the same two corners of the polygon. Seams keep off these edges, and so
/// every corner of a polygon has one UV. The edge along which a keyhole touches itself is none: it is
/// a side of the polygon, twice, and between four of its corners.
std::vector<bool> EdgesInsidePolygons(const Surface& surface);

/// The surface's own triangles, on its own vertices.
PolygonSoup TrianglesOf(const Surface& surface);

/// A surface of a soup and the UVs (3F, finite) of its corners.
struct MappedSurface {
  const Surface& surface;
  const CornerUv& uv;
};

/// The input, its points, polygons and corners in its own order, with the UVs of its surfaces as
/// texture coordinates: equal UVs of the corners at one vertex are written once. A corner that no
/// surface has gets the UV of another one of its polygon, and a polygon that no surface has the UV
/// of one of its vertices at all of its corners, which has no area. A polygon that is torn along a
/// diagonal, that covers itself in the image, or that is several loops comes as its triangles. What circle_patterns writes.
PolygonSoup AttachUv(const PolygonSoup& input, const std::vector<MappedSurface>& surfaces);
PolygonSoup AttachUv(const PolygonSoup& input, const Surface& surface, const CornerUv& uv);

/// The same per corner of the input (C): of a polygon that is torn, at each corner the UV of one of
/// its triangles.
std::vector<Eigen::Vector2d> UvOfCorners(const PolygonSoup& input,
                                         const std::vector<MappedSurface>& surfaces);

/// Every triangle split into four at the midpoints of its edges, `levels` times: 4^levels times as
/// many, similar to those they come from, so that the surface and its angles stay as they are.
/// Old vertices keep their numbers; triangle f becomes 4 f to 4 f + 3, first those at its corners
/// 0, 1 and 2, then the one in the middle. Edges are told apart by their ends; texture is left out.
/// @pre triangles only.
PolygonSoup MidpointSubdivision(const PolygonSoup& soup, int levels);

}  // namespace cirque

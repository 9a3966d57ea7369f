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
  /// V: the vertex's number in the soup (they differ by isolated vertices).
  std::vector<Index> soup_vertex;
  /// F: the polygon that the face is a part of; faces keep the soup's order.
  std::vector<Index> soup_polygon;
};

/// The Euclidean length of every edge (E), without underflow or overflow.
EdgeLengths MeasureEdgeLengths(const Surface& surface);

/// The surface's own triangles, on its own vertices.
PolygonSoup TrianglesOf(const Surface& surface);

/// The soup of the surface's own triangles on all of the input's points (isolated ones too, in the
/// input's order), with the given UVs as texture coordinates: equal UVs of the corners at one
/// vertex are written once. UVs must be finite. What circle_patterns writes as OBJ.
PolygonSoup AttachUv(const PolygonSoup& input, const Surface& surface, const CornerUv& uv);

/// Every triangle split into four at the midpoints of its edges, `levels` times: 4^levels times as
/// many, similar to those they come from, so that the surface and its angles stay as they are.
/// Old vertices keep their numbers; triangle f becomes 4 f to 4 f + 3, first those at its corners
/// 0, 1 and 2, then the one in the middle. Edges are told apart by their ends; texture is left out.
/// @pre triangles only.
PolygonSoup MidpointSubdivision(const PolygonSoup& soup, int levels);

}  // namespace cirque

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
  std::vector<Eigen::Vector3d> position;  ///< per vertex of the triangulation
  std::vector<Index>
      soup_vertex;  ///< per vertex: its number in the soup (they differ by isolated vertices)
  std::vector<Index>
      soup_polygon;  ///< per face: the polygon it is a part of; faces keep the soup's order
};

/// The Euclidean length of every edge, without underflow or overflow.
EdgeLengths MeasureEdgeLengths(const Surface& surface);

/// The surface's own triangles, on its own vertices.
PolygonSoup TrianglesOf(const Surface& surface);

/// The soup of the surface's own triangles on all of the input's points (isolated ones too, in the
/// input's order), with the given UVs as texture coordinates: equal UVs of the corners at one
/// vertex are written once. UVs must be finite. What circle_patterns writes as OBJ.
PolygonSoup AttachUv(const PolygonSoup& input, const Surface& surface, const CornerUv& uv);

}  // namespace cirque

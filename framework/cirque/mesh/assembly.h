#pragma once

#include <utility>
#include <vector>

#include "cirque/core/types.h"
#include "cirque/io/polygon_soup.h"

/// From polygons to oriented triangles, as Preflight goes: every polygon is split into triangles,
/// these are glued along their edges, and where the gluing allows they are turned to agree.
namespace cirque {

/// The polygons of a soup as triangles, in the soup's order.
struct TriangleSoup {
  std::vector<Index> vertex;   ///< 3F
  std::vector<Index> polygon;  ///< F: the polygon each triangle is a part of
  std::vector<Index> corner;   ///< 3F: the corner of the soup that each corner is
  /// 3F: the halfedge across a diagonal of the split, kNone on an edge of the polygon; halfedge
  /// 3 f + k lies opposite corner k.
  std::vector<Index> mate;
};

/// Polygons that are no polygons.
struct BadFaces {
  std::vector<Index> repeated_vertex;  ///< a vertex occurs twice, and it is no keyhole
  std::vector<Index> zero_area;        ///< every split has a triangle of no area
};

/// Whether twice the area of the triangle is at most 1e-12 times its longest edge squared.
bool IsZeroArea(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/// Splits every polygon into triangles inside itself, by its shape alone: how the file numbers
/// vertices, and at which corner a polygon begins, makes no difference. A quad is split along the
/// diagonal with the larger least angle whose triangles face one way, others by ears
/// (ear_cutting.h), or along the best fan where there are none. Then RaiseValences. A polygon that
/// runs along an edge twice, a keyhole round a hole, is split like others, and its edge is glued; one
/// that comes back to a vertex in loops that face one way, loop by loop, into fewer triangles. Others
/// that repeat a vertex are left out; those of zero area are split all the same. Polygons
/// with a vertex that is not finite are not judged by area.
TriangleSoup SplitIntoTriangles(const PolygonSoup& soup, BadFaces* bad);

/// Flips diagonals inside polygons so that inner vertices have at least three triangles, below which
/// no angles less than pi add up to 2 pi; and, where no more than half of the least angle is lost,
/// four, and two at vertices on the boundary, below which it cannot be straight there. The poorest
/// first; no vertex becomes poorer than that, and triangles face the way their polygon does.
void RaiseValences(const PolygonSoup& soup, TriangleSoup* triangles);

/// How triangles on numbered vertices meet along their edges, before they are oriented. Halfedge
/// h = 3 f + k is the edge of triangle f opposite its corner k.
struct Gluing {
  /// 3F: the halfedge on the other side, kNone on the boundary and where more than two triangles
  /// meet.
  std::vector<Index> mate;
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

/// Which triangles to turn around so that neighbours agree.
struct Orientation {
  std::vector<bool> turn;  ///< F: the minority of each piece of the surface that hangs together
  /// Of every piece that is one-sided a halfedge at which no choice agrees.
  std::vector<Index> one_sided = {};
};

/// Follows the glued edges from triangle to triangle.
Orientation OrientTriangles(const std::vector<Index>& triangles, const Gluing& gluing);

/// Turns the triangles around: their second and third corners change places, and `mate` follows.
void TurnTriangles(const std::vector<bool>& turn, TriangleSoup* triangles,
                   std::vector<Index>* mate);

}  // namespace cirque

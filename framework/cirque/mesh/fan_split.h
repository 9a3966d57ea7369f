#pragma once

#include <vector>

#include "cirque/io/polygon_soup.h"

namespace cirque {

/// The polygons of a soup as triangles, in the soup's order.
struct TriangleSoup {
  std::vector<Index> vertex;   ///< 3F
  std::vector<Index> polygon;  ///< F: the polygon each triangle is a part of
  std::vector<Index> mate;  ///< 3F: the halfedge across a diagonal of the split, kNone on an edge
                            ///< of the polygon; halfedge 3 f + k lies opposite corner k
};

/// Polygons that are no polygons.
struct BadFaces {
  std::vector<Index> repeated_vertex;  ///< a vertex occurs twice
  std::vector<Index> zero_area;        ///< every split has a triangle of no area
};

/// Whether twice the area of the triangle is at most 1e-12 times its longest edge squared.
bool IsZeroArea(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/// Splits every polygon into the fan of its first corner that makes no triangle of zero area.
/// Polygons that repeat a vertex are left out; those of zero area are split all the same. Polygons
/// with a vertex that is not finite are not judged by area.
TriangleSoup SplitIntoFans(const PolygonSoup& soup, BadFaces* bad);

}  // namespace cirque

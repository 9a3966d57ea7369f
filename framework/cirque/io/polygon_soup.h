#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/types.h"

namespace cirque {

class TextWriter;

/// What a mesh file says, before anything is judged: P polygons with C corners in all on V numbered
/// points, in the file's order. A triangle and a quadrilateral on four points:
///
///   position        (0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)
///   first_corner    0, 3, 7
///   corner          0, 1, 2,  0, 1, 3, 2
struct PolygonSoup {
  std::vector<Eigen::Vector3d> position;  ///< V
  /// P + 1: polygon p owns corners [first_corner[p], first_corner[p + 1]).
  std::vector<Index> first_corner = {0};
  std::vector<Index> corner;             ///< C: the vertex of each polygon corner, from 0
  std::vector<Eigen::Vector2d> texture;  ///< texture coordinates; empty: the file has none
  /// C: per corner its texture coordinate or kNone; empty without texture.
  std::vector<Index> corner_texture;
  /// Where the first vertex that is not finite stands, "path:line" or the like; else empty.
  std::string not_finite_at;

  Index num_polygons() const { return static_cast<Index>(first_corner.size()) - 1; }
};

/// For the formats: adds the polygon with these corners, counted from 0, to a soup that has all of
/// its vertices. Returns what is wrong with it, empty when nothing is; the polygon is then part of
/// the soup.
std::string AddPolygon(const std::vector<std::int64_t>& corners, PolygonSoup* soup);

/// For every point the first one with equal coordinates (0 equals -0; a point that is not finite
/// equals none): itself where there is none before it. Expected O(points).
std::vector<Index> FirstOfEqualPoints(const std::vector<Eigen::Vector3d>& points);

/// For the formats: the body that OFF and PLY share,
///
///   x y z            V lines, in the fewest digits that read back to the same bits
///   n v_1 ... v_n    P lines: the number of corners and their vertices, counted from 0
///
/// without texture coordinates.
void WritePointsAndPolygons(const PolygonSoup& mesh, TextWriter* out);

}  // namespace cirque

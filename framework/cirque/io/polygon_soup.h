#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/types.h"

namespace cirque {

/// What a mesh file says, before anything is judged: polygons on numbered points, in the file's
/// order.
struct PolygonSoup {
  std::vector<Eigen::Vector3d> position;
  std::vector<Index> first_corner = {
      0};  ///< P + 1: polygon p owns corners [first_corner[p], first_corner[p + 1])
  std::vector<Index> corner;             ///< the vertex of each polygon corner, 0-based
  std::vector<Eigen::Vector2d> texture;  ///< texture coordinates, empty when the file has none
  std::vector<Index>
      corner_texture;  ///< per corner its texture coordinate or kNone; empty without texture

  Index num_polygons() const { return static_cast<Index>(first_corner.size()) - 1; }
};

}  // namespace cirque

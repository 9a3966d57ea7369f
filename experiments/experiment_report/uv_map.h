#pragma once

#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/mesh/surface.h"

namespace cirque::experiment_report {

/// A map that a run kept: the surface and its flat image.
struct UvMap {
  Surface surface;
  CornerUv uv;

  /// The points of the image: a vertex has one for every different uv of its corners.
  std::vector<Index> point;               ///< 3F: of each corner
  std::vector<Index> point_vertex;        ///< the vertex of each point
  std::vector<Eigen::Vector2d> point_uv;  ///< its place
  std::vector<Index> seams;               ///< halfedges, both sides: interior, their uvs differ
  std::vector<Index> boundary;            ///< halfedges on the surface's boundary
  std::vector<std::pair<Index, double>> cones;  ///< interior vertices, angle sum in the image [rad]
};

/// Reads an OBJ with `vt`, and finds its seams and cones. Error: no such file, no uv at a corner.
StatusOr<UvMap> ReadUvMap(const std::string& path);

}  // namespace cirque::experiment_report

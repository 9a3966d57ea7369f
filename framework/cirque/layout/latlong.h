#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// Latitude and longitude of a map to the unit sphere as texture coordinates.
struct LatLong {
  CornerUv uv;                  ///< 3F
  std::vector<Index> at_poles;  ///< faces with (0, 0, 1) or (0, 0, -1) inside: no two-dimensional
                                ///< triangle is their image, their third side spans the seam
};

/// u = longitude / 2 pi + 1/2, v = latitude / pi + 1/2, per corner. The u of a triangle lie within
/// 1/2 of each other, the least of them in [0, 1): triangles across the date line are all at its
/// eastern end and reach beyond 1, so that the texture opens along one path of edges and none is
/// smeared over it. A corner at a pole of the sphere, where longitude has no meaning, gets the mean
/// u of its triangle's others.
LatLong LatLongUv(const Triangulation& triangulation, const std::vector<Eigen::Vector3d>& position);

}  // namespace cirque

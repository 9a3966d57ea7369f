#pragma once

#include <string>

#include "cirque/domains/domain.h"
#include "cirque/io/polygon_soup.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// The surface's triangles with the input's vertices, in the input's order, on the sphere.
PolygonSoup SphereMesh(const PolygonSoup& input, const Surface& surface,
                       const std::vector<Eigen::Vector3d>& position);

/// Text PLY: the input's points (x, y, z) and theirs on the sphere (sx, sy, sz); per face
/// quasi_conformal and angle_distortion [rad].
std::string SpherePly(const PolygonSoup& input, const Surface& surface, const SurfaceMap& map);

}  // namespace cirque

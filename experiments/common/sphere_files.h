#pragma once

#include <string>

#include "cirque/core/status.h"
#include "cirque/domains/domain.h"
#include "cirque/domains/exact_mesh.h"
#include "cirque/io/polygon_soup.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// The surface's triangles with the input's vertices, in the input's order, on the sphere.
PolygonSoup SphereMesh(const PolygonSoup& input, const Surface& surface,
                       const std::vector<Eigen::Vector3d>& position);

/// Text PLY: the input's points (x, y, z) and theirs on the sphere (sx, sy, sz); per face
/// quasi_conformal and angle_distortion [rad].
std::string SpherePly(const PolygonSoup& input, const Surface& surface, const SurfaceMap& map);

/// Writes an exact map to the sphere. .obj: points on the sphere (v), where each lies on the input as
/// texture coordinates of space (vt, the same numbers), and a group per face of the input; .ply: as
/// SpherePly, per face the one of the input (input_face, from 0); else the points on the sphere alone.
Status WriteExactSphere(const std::string& path, const ExactMesh& exact);

}  // namespace cirque

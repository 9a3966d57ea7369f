#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "cirque/io/glb_document.h"
#include "cirque/io/polygon_soup.h"
#include "cirque/math/unit_lattice.h"

namespace cirque {

/// The material of a mesh with texture coordinates, as glTF describes it, and what it shows: a checkerboard of about
/// 32 squares across the map (KHR_texture_transform), or the pattern of the lattice that the map repeats by.
GlbDocument::Json TexturedMaterial(const PolygonSoup& mesh, std::optional<LatticeKind> lattice,
                                   GlbDocument* document);

/// The material of what has no texture; `colour` red, green, blue as screens have them (sRGB).
GlbDocument::Json PlainMaterial(const Eigen::Vector3d& colour = Eigen::Vector3d::Ones());

/// Where the picture has a place of the map, v counted downwards: on a lattice a period is a unit.
Eigen::Vector2d InPicture(const Eigen::Vector2d& uv, std::optional<LatticeKind> lattice);

}  // namespace cirque

#pragma once

#include <vector>

#include "cirque/io/polygon_soup.h"
#include "cirque/verify/mesh_match.h"

namespace cirque::verify {

/// Faces of IN of which a map need not speak, since they add nothing to the surface or cannot be
/// cut into triangles with an area: those with fewer than three different vertices, those that pass
/// one of their sides twice the same way or turn back along it or are loops that meet at a vertex,
/// those whose corners lie on one line (to 1e-12 of their size), those with two different vertices at
/// one place, one after the other, and at edges of more than two faces those with the vertices of an
/// earlier one there.
std::vector<bool> MaySetAside(const PolygonSoup& in);

/// Those of `faces` whose images have no area, exactly: they cover nothing and turn nothing over. The
/// others are to be judged like any face.
std::vector<bool> KeepInLine(std::vector<bool> faces, const PolygonSoup& in, const MeshMatch& match,
                             const PolygonSoup& out);

}  // namespace cirque::verify

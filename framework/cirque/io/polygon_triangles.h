#pragma once

#include <array>
#include <vector>

#include "cirque/io/polygon_soup.h"

namespace cirque {

/// For formats of triangles: a polygon's triangles as corners of the soup. It is looked at in its map's
/// plane, else in the plane that it is nearest to, and ears are cut off one after the other; what has none is
/// cut from its first corner.
std::vector<std::array<Index, 3>> TrianglesOfPolygon(const PolygonSoup& mesh, Index polygon);

}  // namespace cirque

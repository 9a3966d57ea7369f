#pragma once

#include "cirque/io/polygon_soup.h"

namespace cirque {

/// Every triangle split into four at the midpoints of its edges, `levels` times: 4^levels times as
/// many, similar to those they come from, so that the surface and its angles stay as they are.
/// Old vertices keep their numbers; triangle f becomes 4 f to 4 f + 3, first those at its corners
/// 0, 1 and 2, then the one in the middle. Edges are told apart by their ends; texture is left out.
/// @pre triangles only.
PolygonSoup MidpointSubdivision(const PolygonSoup& soup, int levels);

}  // namespace cirque

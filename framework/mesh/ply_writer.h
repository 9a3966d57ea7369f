#pragma once

#include <string>

#include "cirque/mesh/polygon_soup.h"

namespace cirque {

/// The mesh as text PLY with double coordinates, without texture coordinates.
std::string FormatPly(const PolygonSoup& mesh);

}  // namespace cirque

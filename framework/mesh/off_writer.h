#pragma once

#include <string>

#include "cirque/mesh/polygon_soup.h"

namespace cirque {

/// The mesh as text OFF, without texture coordinates.
std::string FormatOff(const PolygonSoup& mesh);

}  // namespace cirque

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cirque/io/polygon_soup.h"

namespace cirque {

/// Adds the polygon with these corners, counted from 0, to a soup that has all of its vertices.
/// Returns what is wrong with it, empty when nothing is; the polygon is then part of the soup.
std::string AddPolygon(const std::vector<std::int64_t>& corners, PolygonSoup* soup);

}  // namespace cirque

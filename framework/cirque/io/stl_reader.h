#pragma once

#include <string>
#include <string_view>

#include "cirque/core/status.h"
#include "cirque/io/polygon_soup.h"

namespace cirque {

/// Parses STL, text or binary (told apart by the length that a binary file announces). STL repeats
/// every vertex in each of its triangles: vertices of equal coordinates become one, numbered by
/// their first appearance. Several solids become one mesh; normals and attributes are ignored.
StatusOr<PolygonSoup> ParseStl(const std::string& path, std::string_view content);

}  // namespace cirque

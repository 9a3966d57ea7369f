#pragma once

#include <string>
#include <string_view>

#include "cirque/core/status.h"
#include "cirque/io/polygon_soup.h"

namespace cirque {

/// Parses STL, text or binary, told apart by the length that a binary file announces:
///
///   80 bytes     anything
///   uint32       F; all numbers are little-endian
///   F times:     float32 normal[3], corner[3][3]; 2 bytes of attributes
///
/// and as text, a statement a line:
///
///   solid NAME
///     facet normal x y z
///       outer loop
///         vertex x y z          three times
///       endloop
///     endfacet
///   endsolid NAME
///
/// STL repeats every vertex in each of its triangles: vertices of equal coordinates become one,
/// numbered by their first appearance. Several solids become one mesh; normals and attributes are
/// ignored.
///
/// Errors are "path:line: ..." in text, else "path: ...": a word or a coordinate that is missing or
/// another, a file that ends early, a binary file of another length than it announces.
StatusOr<PolygonSoup> ParseStl(const std::string& path, std::string_view content);

}  // namespace cirque

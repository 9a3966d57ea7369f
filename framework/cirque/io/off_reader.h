#pragma once

#include <string>
#include <string_view>

#include "cirque/core/status.h"
#include "cirque/io/polygon_soup.h"

namespace cirque {

/// Parses text OFF: the keyword (OFF, or COFF, NOFF, STOFF and their mixtures), the numbers of
/// vertices, faces and edges, a line a vertex, a line a face. Normals, colours and texture
/// coordinates behind the coordinates and the corners are ignored; comments are allowed. `path`
/// serves the messages, which start with path:line.
StatusOr<PolygonSoup> ParseOff(const std::string& path, std::string_view text);

}  // namespace cirque

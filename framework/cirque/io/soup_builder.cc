#include "cirque/io/soup_builder.h"

#include <fmt/format.h>

namespace cirque {

std::string AddPolygon(const std::vector<std::int64_t>& corners, PolygonSoup* soup) {
  if (corners.size() < 3) {
    return fmt::format("a face needs at least 3 corners, this one has {}; complete or remove it",
                       corners.size());
  }
  const auto num_vertices = static_cast<std::int64_t>(soup->position.size());
  for (const std::int64_t v : corners) {
    if (v < 0 || v >= num_vertices) {
      return fmt::format("expected a vertex index from 0 to {}, got {}; correct the index",
                         num_vertices - 1, v);
    }
  }
  for (const std::int64_t v : corners) soup->corner.push_back(static_cast<Index>(v));
  soup->first_corner.push_back(static_cast<Index>(soup->corner.size()));
  return "";
}

}  // namespace cirque

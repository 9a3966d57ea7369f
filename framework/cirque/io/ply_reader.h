#pragma once

#include <string>
#include <string_view>

#include "cirque/core/status.h"
#include "cirque/io/polygon_soup.h"

namespace cirque {

/// Parses PLY, text or binary of either byte order: `x`, `y`, `z` of the element `vertex` and the
/// list `vertex_indices` (or `vertex_index`) of the element `face`, of any types. All other
/// elements and properties (colours, normals, texture coordinates) are skipped. `path` serves the
/// messages.
StatusOr<PolygonSoup> ParsePly(const std::string& path, std::string_view content);

}  // namespace cirque

#pragma once

#include <string>
#include <string_view>

#include "cirque/core/status.h"
#include "cirque/io/polygon_soup.h"

namespace cirque {

/// Parses Wavefront OBJ: `v x y z` (weights and colours after them are ignored), `vt u [v]`, and
/// `f` with corners v, v/vt, v//vn or v/vt/vn. Indices count from 1, or backwards from the latest
/// when negative; they may refer to later lines. Normals and every other keyword are ignored.
/// Comments, blank lines and line continuations are allowed. `path` serves the messages, which
/// start with path:line.
StatusOr<PolygonSoup> ParseObj(const std::string& path, std::string_view text);

}  // namespace cirque

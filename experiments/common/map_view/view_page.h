#pragma once

#include <string>
#include <utility>
#include <vector>

#include "experiments/common/map_view/uv_map.h"

namespace cirque {

/// A page with more triangles would be more than a browser turns smoothly: some 20 MB.
inline constexpr Index kMostViewedTriangles = 1500000;

/// One map to turn and zoom, as a document that needs nothing else; below it the facts, name and
/// value.
std::string ViewPage(const std::string& title, const UvMap& map,
                     const std::vector<std::pair<std::string, std::string>>& facts);

}  // namespace cirque

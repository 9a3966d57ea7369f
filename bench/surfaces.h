#pragma once

#include <string>

#include "cirque/mesh/surface.h"

namespace cirque {

/// The surface that a generator makes of about that many triangles. Made once.
const Surface& BenchSurface(const std::string& generator, int triangles);

/// The terrain stretched along one axis, so that a good part of its edges is not Delaunay. Made
/// once.
const Surface& StretchedTerrain(int triangles);

}  // namespace cirque

#pragma once

#include "cirque/domains/domain.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// The independent judge takes the surface, refined by the map, for the surface and its map for a valid one:
/// every face covered once, areas to 1e-12.
void ExpectExactMapIsAccepted(const Surface& surface, const SurfaceMap& map);

}  // namespace cirque

#pragma once

#include <vector>

#include "cirque/mesh/surface.h"

namespace cirque {

/// The inner edges (E) whose two ends lie on one boundary loop. A map that puts that loop on a circle
/// has no room for them: no circle pattern has a face with all corners on the circle that all others
/// lie inside of, or, about a hole, an edge across the hole.
std::vector<bool> ChordsOf(const Triangulation& triangulation, const std::vector<Index>& loop);

/// The same surface with a further vertex at the middle of each of these edges (E), the triangles there
/// cut into two to four. Old vertices keep their numbers, of which the new ones follow; these are
/// kNone in the soup, as all corners are, and a triangle's polygon is that of the one it was cut from.
Surface SplitEdges(const Surface& surface, const std::vector<bool>& edges);

/// Per face of SplitEdges' surface the face of `triangulation` that it was cut from; not decreasing.
/// (The new vertices are in the order of their edges.)
std::vector<Index> FacesBeforeSplit(const Triangulation& triangulation,
                                    const std::vector<bool>& edges);

}  // namespace cirque

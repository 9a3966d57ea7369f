#pragma once

#include <utility>
#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// The faces whose uv triangle is not positively oriented, by exact arithmetic on the coordinates
/// as they are.
std::vector<Index> FlippedFaces(const Triangulation& triangulation, const CornerUv& uv);

/// The pairs of boundary halfedges whose images cross or touch although they share no vertex, at
/// most `limit` of them, by exact arithmetic. A map of a disk without flips and without such pairs
/// is injective. Sorts by x and prunes.
std::vector<std::pair<Index, Index>> BoundaryCrossings(const Triangulation& triangulation,
                                                       const CornerUv& uv, int limit = 1);

}  // namespace cirque

#pragma once

#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// The core's boundary vertices, the best poles first: where the boundary is straight already, as
/// are the neighbours, and where the edges are Delaunay.
std::vector<Index> RankPoles(const Triangulation& whole, const EdgeLengths& lengths,
                             const std::vector<bool>& core);

}  // namespace cirque

#pragma once

#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// `count` of the candidates: the first one, then each time the one farthest from all chosen before
/// (T. Gonzalez, "Clustering to minimize the maximum intercluster distance", 1985), the earlier
/// candidate where distances tie. Distances run along edges. `count` must not exceed their number.
std::vector<Index> FarthestVertices(const Triangulation& triangulation, const EdgeLengths& lengths,
                                    const std::vector<Index>& candidates, Index count);

}  // namespace cirque

#pragma once

#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"

namespace cirque {

/// MakeIntrinsicDelaunay of a metric that is to stay as it is: flips need leave no vertex room for
/// other angle sums than it has. `locked` as there.
IntrinsicTriangulation MakeDelaunayOfMetric(const Triangulation& triangulation,
                                            const EdgeLengths& lengths,
                                            std::vector<bool> locked = {});

}  // namespace cirque

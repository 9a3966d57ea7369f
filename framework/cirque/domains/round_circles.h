#pragma once

#include <complex>
#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"
#include "cirque/pipeline/summaries.h"

namespace cirque {

/// The mean of the places of every vertex, which the seams of a layout part by rounding.
std::vector<std::complex<double>> MeanPlaces(const Triangulation& triangulation,
                                             const CornerUv& uv);

/// Moves and scales the circle of the outer loop, the first one, to the unit circle, and puts all
/// boundary vertices on their circles. Loops are halfedges.
RoundHolesSummary PutOnCircles(const Triangulation& triangulation,
                               const std::vector<std::vector<Index>>& loops,
                               std::vector<std::complex<double>>* place);

}  // namespace cirque

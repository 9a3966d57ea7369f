#pragma once

#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// The corner angles of the Euclidean triangles with these edge lengths [rad], computed without
/// cancellation for needles (W. Kahan, "Miscalculating Area and Angles of a Needle-like Triangle",
/// 2014). A face that violates the triangle inequality gets angles 0, 0, pi, the pi opposite its
/// longest edge.
CornerAngles MeasureCornerAngles(const Triangulation& triangulation, const EdgeLengths& lengths);

/// The sum of the corner angles at every vertex [rad].
std::vector<double> VertexAngleSums(const Triangulation& triangulation, const CornerAngles& angles);

}  // namespace cirque

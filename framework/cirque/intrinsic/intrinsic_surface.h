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

/// A triangulated surface with what follows from its connectivity and lengths alone, computed once
/// and handed down. It refers to the triangulation and the lengths, which must outlive it.
struct IntrinsicSurface {
  const Triangulation& triangulation;
  const EdgeLengths& lengths;
  CornerAngles angles;         ///< 3F [rad], MeasureCornerAngles
  std::vector<bool> boundary;  ///< per vertex whether it lies on the boundary
  std::vector<Index> corners;  ///< per vertex its number of corners
};

/// Measures it: corner angles by the law of cosines [rad], boundary and corners from the gluing.
IntrinsicSurface MeasureSurface(const Triangulation& triangulation, const EdgeLengths& lengths);

/// The area of its triangles.
double SurfaceArea(const IntrinsicSurface& surface);

}  // namespace cirque

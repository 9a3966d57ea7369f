#pragma once

#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"

namespace cirque {

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

}  // namespace cirque

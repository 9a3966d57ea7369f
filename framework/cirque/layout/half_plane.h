#pragma once

#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"
#include "cirque/math/moebius.h"

namespace cirque {

/// A flat disk with a straight piece of boundary, in the upper half-plane.
struct HalfPlane {
  std::vector<Complex> position;  ///< per vertex; of the straight piece exactly real
  double straightness = 0;  ///< largest |y| on the straight piece before that, over its length
  bool increasing = false;  ///< whether the straight piece's vertices follow each other strictly
};

/// Moves a layout so that the chain of boundary vertices, the surface on its left, runs along the
/// real axis in its direction, from 0 to 1. @pre the chain's ends are apart.
HalfPlane MoveToHalfPlane(const Triangulation& triangulation, const CornerUv& layout,
                          const std::vector<Index>& chain);

}  // namespace cirque

#pragma once

#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// The faces whose uv triangle is not positively oriented, by exact arithmetic on the coordinates
/// as they are.
std::vector<Index> FlippedFaces(const Triangulation& triangulation, const CornerUv& uv);

/// How boundary edges that share no vertex lie in the image.
enum class BoundaryContact {
  kApart,    ///< a map of a disk without flips is then injective
  kTouch,    ///< some touch or run along each other, none cross: opened seams can do so
  kCrossing  ///< some cross, so the image overlaps itself
};

/// The strongest contact, by exact arithmetic. Sorts by x and prunes.
BoundaryContact FindBoundaryContact(const Triangulation& triangulation, const CornerUv& uv);

}  // namespace cirque

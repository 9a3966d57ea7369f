#pragma once

#include <vector>

#include "cirque/core/triangulation.h"
#include "cirque/layout/seams.h"

namespace cirque {

/// Moves UVs so that every seam's two sides differ by exactly the rotation multiple[i] 2 pi / order
/// and one translation, as far as doubles hold coordinates: the ends of all seams by the least
/// displacement that makes their motions agree (a small linear system over the nodes of the cut),
/// then the right side of every seam to where its left side is taken. Rotations of pi/2 are exact
/// in floating point. Returns the largest displacement of a UV; it is of the size of the gaps in
/// `report`, and triangles smaller than that should be checked again.
/// `multiple`: of IntegerRotations, one for every seam of `report`.
double SnapSeams(const Triangulation& triangulation, const Cut& cut, const SeamReport& report,
                 const std::vector<int>& multiple, int order, CornerUv* uv);

}  // namespace cirque

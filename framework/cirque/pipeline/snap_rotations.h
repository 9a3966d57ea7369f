#pragma once

#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// 4 where every cone's angle is fixed to a multiple of pi/2, 6 where to one of pi/3, 0 otherwise.
/// 4 without cones: the transitions of a flat surface without handles and loops, and of a flat
/// torus, then are translations.
int CommonRotationOrder(const ConeTargets& targets, const std::vector<Index>& cones);

/// Makes the rotations across all seams exact multiples of 2 pi / order, and the two sides of every
/// seam differ by just that and a translation. False, with `uv` untouched, where some rotation is
/// no multiple, as around a handle or a boundary loop it need not be, or where exactness would
/// flip a triangle.
bool SnapRotations(const Triangulation& triangulation, const Cut& cut,
                   const std::vector<Index>& cones, const CornerAngles& flat_angles, int order,
                   CornerUv* uv);

}  // namespace cirque

#pragma once

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/overlay.h"

namespace cirque {

/// Straight lines of a Euclidean metric given by the lengths of `other`: the faces crossed are
/// unfolded into the plane. Both must outlive the rule.
PositionRule StraightLines(const Triangulation& other, const EdgeLengths& lengths);

}  // namespace cirque

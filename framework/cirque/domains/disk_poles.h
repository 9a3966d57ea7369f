#pragma once

#include <vector>

#include "cirque/intrinsic/intrinsic_surface.h"

namespace cirque {

/// The core's boundary vertices, the best poles first: where the boundary is straight already, as
/// are the neighbours, and where the edges are Delaunay.
std::vector<Index> RankPoles(const IntrinsicSurface& whole, const std::vector<bool>& core);

}  // namespace cirque

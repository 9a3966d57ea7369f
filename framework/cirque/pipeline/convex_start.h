#pragma once

#include <optional>

#include "cirque/core/metric.h"
#include "cirque/intrinsic/intrinsic_surface.h"

namespace cirque {

/// A map of a topological disk to a round one without flipped faces, the boundary by its lengths (W.
/// Tutte, 1963; EmbedConvexly): where a refinement that leaves conformality can begin when doubles do
/// not hold the conformal map. Nothing: they do not hold this one either.
std::optional<CornerUv> EmbedInDisk(const IntrinsicSurface& disk);

}  // namespace cirque

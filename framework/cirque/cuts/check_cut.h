#pragma once

#include <vector>

#include "cirque/core/cut.h"
#include "cirque/core/metric.h"
#include "cirque/core/status.h"

namespace cirque {

/// The interior vertices whose angle sum is not required to be 2 pi.
std::vector<Index> ConeVertices(const Triangulation& triangulation, const ConeTargets& targets);

/// Whether the surface can be laid out along the cut: every patch a disk, every cone on the
/// boundary of its patches. Errors (invalid input): all patches and cones concerned, numbered from
/// 0, and what to do.
Status CheckCut(const Triangulation& triangulation, const Cut& cut,
                const std::vector<Index>& cones);

}  // namespace cirque

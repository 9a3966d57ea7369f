#pragma once

#include "cirque/domains/domain.h"

namespace cirque {

/// Parameterize: a surface of any topology, opened along a cut where it is no disk or has cones.
Status MapToPlane(const Surface& surface, const MapRequest& request, const SolveControl& control,
                  SurfaceMap* map);

}  // namespace cirque

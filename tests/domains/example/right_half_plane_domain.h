#pragma once

#include "cirque/domains/domain.h"

namespace cirque {

/// The example of CONTRIBUTING.md: the right half-plane, the boundary on the imaginary axis. The
/// map to the upper half-plane, turned by -pi/2. Errors: that one's.
Status MapToRightHalfPlane(const Surface& surface, const MapRequest& request,
                           const SolveControl& control, SurfaceMap* map);

}  // namespace cirque

#include "cirque/domains/plane_domain.h"

namespace cirque {

Status MapToPlane(const Surface& surface, const MapRequest& request, const SolveControl& control,
                  SurfaceMap* map) {
  return Parameterize(surface, request, control, map);
}

}  // namespace cirque

#include "tests/domains/example/right_half_plane_domain.h"

#include <utility>

namespace cirque {

Status MapToRightHalfPlane(const Surface& surface, const MapRequest& request,
                           const SolveControl& control, SurfaceMap* map) {
  MapRequest upper = request;
  upper.domain = "half_plane";
  StatusOr<SurfaceMap> turned = MapSurface(surface, upper, control, &map->certificate);
  if (!turned.ok()) return turned.status();
  for (Eigen::Vector2d& p : turned->uv.value) p = Eigen::Vector2d(p.y(), -p.x());
  *map = *std::move(turned);
  return Status();
}

}  // namespace cirque

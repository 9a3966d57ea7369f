#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/intrinsic_surface.h"

namespace cirque {

/// Places a map whose boundary is spread out by a share in (0, 1]; false where it flips triangles.
using PlaceWithShare = std::function<bool(double share, CornerUv* uv)>;

/// The share of spreading, of a few between 1e-9 and 1, that distorts least among those that flip no
/// triangle: by the area-weighted mean of log(quasi-conformal distortion). Nothing: all do.
std::optional<double> LeastDistortingShare(const IntrinsicSurface& surface,
                                           const PlaceWithShare& place);

/// Places a disk in a polygon of equal angles where the coordinates of its conformal map do not tell
/// vertices apart: the corners by the sides' lengths in the flat metric, boundary vertices along their
/// sides as there, but spread out, towards where their arc lengths on the surface would put them, by
/// the share that distorts least, and what lies inside by a convex embedding, which flips no
/// triangle. The first side runs from 0 along the real axis. `corners` in the boundary's order, the
/// surface on its left; `flat`: lengths of the flat metric. Error (unrepresentable): all shares flip
/// triangles.
Status SpreadInPolygon(const IntrinsicSurface& disk, const EdgeLengths& flat,
                       const std::vector<Index>& corners, CornerUv* uv);

}  // namespace cirque

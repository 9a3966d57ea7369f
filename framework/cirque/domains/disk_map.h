#pragma once

#include <string>
#include <vector>

#include "cirque/domains/domain.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// What maps of a disk to the unit disk and to the half-plane have in common.

/// Of a map that doubles do not hold; `what` they do not: "points of the unit disk".
Status DiskUnrepresentable(const std::string& what);

/// A vertex by its number in the file; kNone for none.
Index FileNumber(const Surface& surface, Index v);

Index CountFalse(const std::vector<bool>& flags);

/// Puts a map without a cut into the result and measures it. Triangles are not flipped but where an
/// exact map is beside it.
void DeliverDisk(const Triangulation& triangulation, const EdgeLengths& lengths, CornerUv uv,
                 SurfaceMap* map);

}  // namespace cirque

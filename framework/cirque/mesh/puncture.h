#pragma once

#include <vector>

#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/mesh/sub_triangulation.h"

namespace cirque {

/// A closed surface without the open star of one vertex.
struct PuncturedSurface : SubTriangulation {
  std::vector<Index> link;  ///< the vertices next to the pole, around it, in the closed surface
  Index pole = kNone;       ///< the vertex removed
};

/// Whether the closed star of the vertex of `corner` is a disk: its neighbours differ from each
/// other and from the vertex itself. (In a Delta-complex they need not.)
bool HasDiskStar(const Triangulation& triangulation, Index corner);

/// Removes the star of `pole`. Errors (invalid input): a star that is no disk, or nothing left.
/// @pre a closed surface.
StatusOr<PuncturedSurface> Puncture(const Triangulation& triangulation, Index pole);

}  // namespace cirque

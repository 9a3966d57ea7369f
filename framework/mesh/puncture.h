#pragma once

#include <vector>

#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// A closed surface without the open star of one vertex. Vertices and faces keep their order.
struct PuncturedSurface {
  Triangulation triangulation;
  std::vector<Index> vertex;  ///< per vertex: its number in the closed surface
  std::vector<Index> face;    ///< per face likewise; halfedge 3 f + k there is 3 face[f] + k here
  std::vector<Index> link;    ///< the vertices next to the pole, around it, in the closed surface
  Index pole = kNone;         ///< the vertex removed
};

/// The corners at a vertex of a closed surface in counter-clockwise order.
std::vector<Index> CornersAround(const Triangulation& triangulation, Index corner);

/// Whether the closed star of the vertex of `corner` is a disk: its neighbours differ from each
/// other and from the vertex itself. (In a Delta-complex they need not.)
bool HasDiskStar(const Triangulation& triangulation, Index corner);

/// Removes the star of `pole`. Errors (invalid input): a star that is no disk, or nothing left.
/// @pre a closed surface.
StatusOr<PuncturedSurface> Puncture(const Triangulation& triangulation, Index pole);

}  // namespace cirque

#pragma once

#include <optional>
#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// A map of a triangulated disk onto itself that turns orientation round, is its own inverse, and takes
/// every edge to one of nearly the same length.
struct MirrorSymmetry {
  std::vector<Index> corner;   ///< 3F: where a corner goes, and the halfedge opposite it
  std::vector<Index> vertex;   ///< V: where a vertex goes
  double length_mismatch = 0;  ///< the largest |l - l'| / max(l, l') of an edge and its image
};

/// The first such symmetry, of those that take the first boundary halfedge to another one, in the
/// boundary's order; nothing where there is none whose lengths agree within `tolerance` (relative).
/// O(B^2 + S F) for a boundary of B edges of which S images agree with the boundary's lengths and valences.
/// @pre one boundary loop, connected.
std::optional<MirrorSymmetry> FindMirrorSymmetry(const Triangulation& disk,
                                                 const EdgeLengths& lengths, double tolerance);

}  // namespace cirque

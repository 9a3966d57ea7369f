#pragma once

#include <optional>
#include <vector>

#include "cirque/mesh/surface.h"

namespace cirque {

/// The polygons of a surface (EdgesInsidePolygons) as a ring of halfedges each.
struct PolygonRings {
  /// 3F: the halfedge after and before one round its polygon; kNone of edges inside polygons.
  std::vector<Index> next, previous;

  bool HasEdge(Index halfedge) const { return next[halfedge] != kNone; }
};

PolygonRings RingsOf(const Surface& surface);

/// A map of the polygons of a disk onto themselves that turns orientation round, is its own inverse, and
/// takes every edge to one of nearly the same length. Diagonals by which polygons are cut into triangles
/// have no part in it.
struct MirrorSymmetry {
  std::vector<Index> halfedge;  ///< 3F: where it goes, turned round; kNone inside polygons
  std::vector<Index> vertex;    ///< V: where it goes
  double length_mismatch = 0;   ///< the largest |l - l'| / max(l, l') of an edge and its image
};

/// The first such symmetry, of those that take the first boundary halfedge to another one, in the
/// boundary's order; nothing where there is none whose lengths agree within `tolerance` (relative).
/// O(B^2 + S F) for a boundary of B edges of which S images agree with the boundary's lengths and valences.
/// @pre a topological disk.
std::optional<MirrorSymmetry> FindMirrorSymmetry(const Surface& disk, const PolygonRings& rings,
                                                 double tolerance);

}  // namespace cirque

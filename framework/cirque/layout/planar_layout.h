#pragma once

#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"
#include "cirque/layout/open_surface.h"

namespace cirque {

/// Flat disks in the plane, each in a frame of its own, with how well they closed.
struct PlanarLayout {
  CornerUv uv;
  Patches patches;
  std::vector<double>
      patch_closure;   ///< max over edges of |placed vector - wanted vector| / length
  double closure = 0;  ///< the largest of them
};

/// Lays out every patch of a flat surface opened along the cut, by edge directions: the direction
/// of every halfedge is a sum of corner angles along the dual tree, every vertex is placed along
/// the minimum spanning tree of the edge lengths by vectors of known length and direction. Errors
/// so add instead of multiplying, and vertices close to each other are joined by short edges. Each
/// patch's origin is put where its triangles are smallest, since doubles are densest there. A
/// vertex on the cut is placed once for every fan of corners that the cut leaves at it.
/// @pre every patch is a disk with flat vertices inside (CheckCut).
PlanarLayout LayOutPatches(const Triangulation& triangulation, const CornerAngles& flat_angles,
                           const EdgeLengths& lengths, const Cut& cut);

/// The same for a surface that is a flat disk as it is.
PlanarLayout LayOutByDirections(const Triangulation& triangulation, const CornerAngles& flat_angles,
                                const EdgeLengths& lengths);

/// The layout with the vertices of the opened surface at these positions.
PlanarLayout LayoutAt(const OpenSurface& open, const std::vector<Eigen::Vector2d>& position);

}  // namespace cirque

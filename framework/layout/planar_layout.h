#pragma once

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// A flat disk in the plane, with how well it closed.
struct PlanarLayout {
  CornerUv uv;
  double closure = 0;  ///< max over edges of |placed vector - wanted vector| / length
};

/// Lays out a flat disk by edge directions: the direction of every halfedge is a sum of corner
/// angles along the dual tree, every vertex is placed along the minimum spanning tree of the edge
/// lengths by vectors of known length and direction. Errors so add instead of multiplying, and
/// vertices close to each other are joined by short edges. The origin is put where triangles are
/// smallest, since doubles are densest there.
/// @pre a connected surface whose interior vertices are flat and whose layout is single valued (a
/// disk).
PlanarLayout LayOutByDirections(const Triangulation& triangulation, const CornerAngles& flat_angles,
                                const EdgeLengths& lengths);

}  // namespace cirque

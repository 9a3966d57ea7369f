#pragma once

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// A simple valid set of cones for a closed surface: the curvature 2 pi chi that Gauss-Bonnet asks
/// for in equal parts on few vertices, far from each other and where the surface itself has much
/// curvature of that sign; every other vertex is flat.
///
/// The curvature comes in parts of pi/2 (cones of 3/2 pi for the sphere, of 5/2 pi for genus 2 and
/// more; none for the torus), or of pi, 2 pi or 4 pi where smaller parts would leave fewer than 8
/// vertices a cone or not find enough vertices with half a corner to spare for such an angle. Sums
/// of the angles are exact in multiples of pi/2. Surfaces with a boundary need no cones:
/// FreeBoundaryTargets. Deterministic.
///
/// Gauss-Bonnet and the corners are necessary for coherent angles, not sufficient: meshes of
/// mechanical parts with many handles can still be proven infeasible with these cones.
///
/// Errors (invalid input): too few vertices with enough corners for the genus.
StatusOr<ConeTargets> SimpleConeTargets(const Triangulation& triangulation,
                                        const EdgeLengths& lengths);

}  // namespace cirque

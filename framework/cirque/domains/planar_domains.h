#pragma once

#include "cirque/domains/domain.h"

namespace cirque {

// Maps that are the plane's own, with the boundary's angle sums prescribed where the shape has
// corners and sides. Errors: those of Parameterize; kUnrepresentable also where triangles come out
// flipped once the sides are put in their place.

/// Map to a rectangle [0, m] x [0, 1] with the four corners given, the first at 0, the second at m;
/// m, the conformal modulus of the surface with these corners, is certificate value
/// conformal_modulus. Without corners: those of MapToPolygon. The sides are made exactly straight
/// and opposite ones exactly equal, by as much as opposite_side_mismatch says. kInvalidInput: no
/// topological disk, or corners that are not four different vertices of the boundary.
Status MapToRectangle(const Surface& surface, const MapRequest& request,
                      const SolveControl& control, SurfaceMap* map);

/// Map to a polygon of equal angles, the first side from (0, 0) to (1, 0). Corners, where none are
/// given, are what a map to the unit disk brings nearest to the corners of a regular polygon of
/// `sides` sides, so that the sides come out nearly equal (certificate: shortest_side,
/// longest_side); a boundary vertex with one triangle must be a corner and is taken first.
///
/// With targets in the request the boundary follows those angles instead: boundary vertices that
/// they leave free become straight (pi). Exterior angles pi - Theta_v must add up to 2 pi on a
/// disk.
///
/// kInvalidInput: no topological disk, fewer than three corners or more than the boundary has
/// vertices, corners that are no different vertices of the boundary. Certificate: PolygonSummary.
Status MapToPolygon(const Surface& surface, const MapRequest& request, const SolveControl& control,
                    SurfaceMap* map);

/// MapToPolygon with three corners: an equilateral triangle, which has no modulus.
Status MapToTriangle(const Surface& surface, const MapRequest& request, const SolveControl& control,
                     SurfaceMap* map);

/// Parameterize: a surface of any topology, opened along a cut where it is no disk or has cones.
Status MapToPlane(const Surface& surface, const MapRequest& request, const SolveControl& control,
                  SurfaceMap* map);

}  // namespace cirque

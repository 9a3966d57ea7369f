#pragma once

#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/domains/domain.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// MapSurface to the plane for a surface of many faces: it is decimated to about as many as
/// ParameterizeOptions::solve_at says (Coarsen) and mapped like that, with cones where it needs any.
/// Vertices come back in the plane (UndoCollapses), and each time that they have doubled all are
/// moved to less distortion (RelaxMap); the map is then refined on the surface itself as the request
/// says. Cones are vertices of the surface with the angles that they had; the cut runs along its
/// edges. The certificate's fit, radii and layout closure are of the decimated surface; its figures of
/// distortion, seams, overlap and flipped triangles of the surface itself, as ever. The map has no
/// flat metric (Parameterization::flat).
///
/// Errors: kInvalidInput for requests with targets, a cut, a boundary, free seams or an exact map;
/// those of MapSurface (kNotConverged for kInfeasible: a proof would be about triangles that the
/// surface does not have) and UndoCollapses; cancelled.
Status MapDecimated(const Surface& surface, const MapRequest& request, const SolveControl& control,
                    SurfaceMap* map);

}  // namespace cirque

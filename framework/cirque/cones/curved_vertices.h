#pragma once

#include <vector>

#include "cirque/cones/cone.h"
#include "cirque/cones/cone_problem.h"

namespace cirque {

/// Cones at the fewest vertices that carry this share of all |K|, the most curved ones; 1: at every
/// vertex that is not flat. Their curvatures make u = 0 at all of them (0 on a boundary, too):
///   mu_c = K_c + (L u)_c, where L u = -K elsewhere
/// (R. Sawhney, K. Crane, "Boundary first flattening", 2017), so that every cone keeps its scale.
/// Where that is beyond both its own curvature and the admissible ones it stays at the bound, and
/// on a closed surface the others share the rest.
///
/// With a share of 1 the flat metric is the surface's own, unfolded, and has coherent angles: those
/// of its intrinsic Delaunay triangulation. The price is a cut to every cone.
/// @pre 0 < share <= 1.
std::vector<Cone> ConesAtCurvedVertices(const ConeProblem& problem, double share);

}  // namespace cirque

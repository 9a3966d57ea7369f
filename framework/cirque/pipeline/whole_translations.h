#pragma once

#include "cirque/pipeline/cut_and_place.h"
#include "cirque/pipeline/parameterization.h"

namespace cirque {

/// Moves the finished map, least, onto a lattice of about ParameterizeOptions::integer_cells cells: of
/// squares where its rotations are multiples of pi/2, of triangles where they are multiples of pi/3
/// (MakeLatticeMap, on the flat metric that the map itself is). UVs are in units of the lattice then:
/// cones lie on its points, and every seam's motion takes the lattice to itself, so that a texture that
/// repeats by it has no seam. Where a triangle would be flipped the map stays as it is, and the
/// certificate says why (IntegerSummary::integer_obstacle).
///
/// @pre the surface is closed.
void MoveOntoLattice(const ParameterizeJob& job, Parameterization* result);

}  // namespace cirque

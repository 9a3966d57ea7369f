#pragma once

#include "cirque/core/status.h"
#include "cirque/layout/planar_layout.h"

namespace cirque {

/// Lays out every patch in the least-squares sense: positions that minimise
///   sum over halfedges h of cot(alpha_h) |(p_tip - p_tail) - w_h|^2,
/// where w_h is the wanted vector of length and direction (as for LayOutPatches) and alpha_h the
/// corner opposite. With exact angles it is the same layout up to translation; where angles carry
/// errors it spreads them over all edges instead of leaving them to the edges outside the tree. The
/// first vertex of each patch is the origin. One sparse factorisation.
/// Errors (not converged): the matrix is not positive definite in floating point.
/// Source of the functional: Pinkall and Polthier's cotangent form of the Dirichlet energy (1993).
StatusOr<PlanarLayout> LayOutByLeastSquares(const Triangulation& triangulation,
                                            const CornerAngles& flat_angles,
                                            const EdgeLengths& lengths, const Cut& cut);

}  // namespace cirque

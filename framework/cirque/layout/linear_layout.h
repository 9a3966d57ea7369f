#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/layout/planar_layout.h"

namespace cirque {

/// Lays out every patch in the least-squares sense: positions that minimise
///   sum_h cot(alpha_h) |(p_tip - p_tail) - w_h|^2   over the halfedges h,
/// where w_h is the target vector, of given length and direction (as for LayOutPatches) and alpha_h
/// the corner opposite. With exact angles it is the same layout up to translation; where angles
/// carry errors it spreads them over all edges instead of leaving them to the edges outside the
/// tree. The first vertex of each patch is the origin. One sparse factorisation.
/// Errors (not converged): the matrix is not positive definite in floating point.
/// Source of the functional: Pinkall and Polthier's cotangent form of the Dirichlet energy (1993).
StatusOr<PlanarLayout> LayOutByLeastSquares(const Triangulation& triangulation,
                                            const CornerAngles& flat_angles,
                                            const EdgeLengths& lengths, const Cut& cut);

/// Positive symmetric edge weights, E: cot(alpha_l) + cot(alpha_r), the angles being those opposite
/// the edge, of a boundary edge one of them, but at least 1e-2 and at most 1e4.
Eigen::VectorXd PositiveCotangents(const Triangulation& triangulation, const CornerAngles& angles);

/// Puts every vertex that is not fixed at the weighted mean of its neighbours, the fixed ones where
/// `position` has them. With the boundary of a disk fixed on a strictly convex polygon, in order,
/// no triangle is flipped, whatever the weights (> 0). Errors (kNotConverged): the system is
/// singular to rounding. Source: M. Floater, "One-to-one piecewise linear mappings over
/// triangulations", Math. Comp. 72 (2003), after W. Tutte (1963).
Status EmbedConvexly(const Triangulation& triangulation, const Eigen::VectorXd& edge_weights,
                     const std::vector<bool>& fixed, std::vector<Eigen::Vector2d>* position);

}  // namespace cirque

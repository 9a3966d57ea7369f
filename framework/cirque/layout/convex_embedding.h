#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// Positive symmetric edge weights: cot(alpha_l) + cot(alpha_r), of a boundary edge one of them,
/// but at least 1e-2 and at most 1e4.
Eigen::VectorXd PositiveCotangents(const Triangulation& triangulation, const CornerAngles& angles);

/// Puts every vertex that is not fixed at the weighted mean of its neighbours, the fixed ones where
/// `position` has them. With the boundary of a disk fixed on a strictly convex polygon, in order,
/// no triangle is flipped, whatever the weights (> 0). Errors (kNotConverged): the system is
/// singular to rounding. Source: M. Floater, "One-to-one piecewise linear mappings over
/// triangulations", Math. Comp. 72 (2003), after W. Tutte (1963).
Status EmbedConvexly(const Triangulation& triangulation, const Eigen::VectorXd& edge_weights,
                     const std::vector<bool>& fixed, std::vector<Eigen::Vector2d>* position);

}  // namespace cirque

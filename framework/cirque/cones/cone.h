#pragma once

#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// A vertex whose angle sum Theta_v shall lie in [lower, upper] [rad]; fixed when they are equal.
struct Cone {
  Index vertex = kNone;
  double lower = 0, upper = 0;
};

/// A cone of this curvature 2 pi - Theta_v.
inline Cone ConeOfCurvature(Index vertex, double curvature) {
  return {vertex, 2 * kPi - curvature, 2 * kPi - curvature};
}

/// The targets of a surface with these cones: every other interior vertex flat, every other
/// boundary vertex free. Errors (invalid input): a vertex that does not exist or is named twice, an
/// interval that is empty, has no positive angle or begins at or above pi a corner, and, on a
/// closed surface, angle sums that cannot add up to pi F (Gauss-Bonnet) to within 1e-9 rad.
StatusOr<ConeTargets> ConeTargetsOf(const Triangulation& triangulation,
                                    const std::vector<Cone>& cones);

/// The way back: the vertices whose targets are not those of FreeBoundaryTargets.
std::vector<Cone> ConesOf(const Triangulation& triangulation, const ConeTargets& targets);

}  // namespace cirque

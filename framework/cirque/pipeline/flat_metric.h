#pragma once

#include <optional>

#include "cirque/core/metric.h"
#include "cirque/intrinsic/intrinsic_surface.h"

namespace cirque {

/// A circle pattern whose flat triangles are those of the surface.
struct FlatMetric {
  CoherentAngles angles;
  LogRadii log_radii;  ///< of the surface's own circumcircles
};

/// Whether the surface itself has the angle sums that are asked for, but for rounding (1e-10 rad).
bool HasAngleSums(const IntrinsicSurface& surface, const ConeTargets& targets);

/// The surface's own corner angles and circumradii, where they are what a flattening looks for: the
/// angle sums meet the targets and no intersection angle is negative, both but for rounding (1e-10
/// rad). Such are surfaces of flat pieces: polygons in a plane, whose triangles may have needles
/// and, in pairs, lie on one circle (theta = 0), where no margin would leave them as they are; and
/// polyhedra whose cones are at their corners. Nothing where the surface is not flat, or has a corner
/// below 1e-7 rad.
std::optional<FlatMetric> FlatMetricOf(const IntrinsicSurface& surface, const ConeTargets& targets);

}  // namespace cirque

#pragma once

#include "cirque/core/infeasibility.h"
#include "cirque/core/metric.h"
#include "cirque/intrinsic/intrinsic_surface.h"

namespace cirque {

/// What a repair did.
struct ConeRepair {
  ConeTargets targets;
  int moved = 0, widened = 0;  ///< cones
};

/// Changes the inner cones of infeasible targets where the proof points: those at its carrying
/// vertices or next to one; all cones where it points at none. In round 1 each of them moves to the
/// neighbour with most corners, if that has more and is no cone yet; in round k > 1 its angle may
/// range over +- (k - 1) pi/4, and that of every other cone over a quarter of that, which Gauss-
/// Bonnet needs. Angles stay within what the corners can reach.
ConeRepair RepairCones(const IntrinsicSurface& surface, const ConeTargets& targets,
                       const InfeasibilityCertificate& proof, int round);

inline constexpr int kMostConeRepairs = 5;

}  // namespace cirque

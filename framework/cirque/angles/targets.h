#pragma once

#include "cirque/core/infeasibility.h"
#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// Refuses angle sums that no angles can have, before anything is solved. Messages name the
/// vertices (0-based) and say what is missing.
///   kInvalidInput  the wrong number of targets, one not finite or negative, lower > upper
///   kInfeasible    a vertex that must reach pi or more at each of its corners on average (an inner
///                  vertex of valence 1 or 2 at 2 pi, a cone angle of valence * pi), one that must
///                  be 0; on a surface where every vertex is constrained, sums of the targets that
///                  miss pi * F (Gauss-Bonnet: sum of lower > pi F, or of upper < pi F) by more
///                  than 1e-9 rad. `proof` (may be null) then proves it, unless rounding is all
///                  that speaks against the exact inequality.
Status CheckTargets(const Triangulation& triangulation, const ConeTargets& targets,
                    InfeasibilityCertificate* proof = nullptr);

}  // namespace cirque

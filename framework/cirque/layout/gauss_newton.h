#pragma once

#include <atomic>

#include <Eigen/Core>

#include "cirque/layout/beltrami_system.h"
#include "cirque/layout/map_objective.h"
#include "cirque/layout/stretch_energy.h"

namespace cirque {

/// When the steps on a part of a map end.
struct StepLimits {
  int steps;        ///< the most
  double decrease;  ///< a step that lowers the objective by less than this share is the last
};

/// Gauss-Newton steps that lower an objective's sum over a part of a map, whose vertices are in z.
/// Writes the vertices of the part that move, reads those that it holds, and returns the number of
/// steps taken; z is as it was where there were none.
///
/// A step solves one Hermitian system (BeltramiSystem), where vertices slide its restriction to their
/// tangents (SlidingCholesky), after which they are put back on their rails; the seams hold by
/// augmented Lagrangians with the same factor. The line search admits no boundary edge that turns
/// back, no face with |mu| >= 1, by exact arithmetic none that is flipped and, where the part has a
/// fence, no image that overlaps itself, and no seam edge whose sides differ by more than 4e-9 of it
/// (or by more than they did).
/// Ends early when cancelled.
int LowerObjective(const MapPart& part, const MapObjective& objective, const StepLimits& limits,
                   const std::atomic<bool>* cancelled, Eigen::VectorXcd* z);

/// The same of a stretch energy, whose steps solve a real system (StretchSystem); `unit`: see there.
int LowerStretch(const MapPart& part, const StretchEnergy& energy, double unit,
                 const StepLimits& limits, const std::atomic<bool>* cancelled, Eigen::VectorXcd* z);

}  // namespace cirque

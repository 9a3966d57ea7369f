#pragma once

#include <functional>

#include "cirque/core/status.h"
#include "cirque/pipeline/cut_and_place.h"
#include "cirque/pipeline/parameterization.h"

namespace cirque {

/// FlattenToTargets (lay_out.h), which is above this.
using FlattenJobToTargets = std::function<Status(const ParameterizeJob&, Parameterization*)>;

/// Makes a map injective that CutAndPlace laid out and whose image covers points twice. Stages, each
/// tried until one holds:
///   curvature  where the angle sums of a boundary are the program's to choose: they are changed least
///              (LeastTurning) so that no arc of the boundary of the opened image turns back by more
///              than half of what it exceeds pi by, then pi, then pi/2, then nothing, and the surface
///              is flattened for them
///   descent    where the image is one disk and the seams need not match: an injective map of the
///              opened surface is lowered towards the flat metric and refined, no step making its
///              boundary cross itself (DescendToInjective). Not taken where charts, which keep the
///              flat metric, are less distorted by far: where the mean of q - 1 is above twice the
///              flat metric's and 0.1, or the L2 norm of log area ratios above twice that and 0.5,
///              unless the refinement asked for leaves conformality
///   charts     the image is cut into charts (CutIntoCharts), which then lie side by side in the unit
///              square; the flat metric stays
/// The certificate's injectivity says what was tried and what held. Errors: cancelled.
Status MakeInjective(const ParameterizeJob& job, const FlattenJobToTargets& flatten,
                     Parameterization* result);

}  // namespace cirque

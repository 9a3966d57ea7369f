#pragma once

#include "cirque/core/status.h"
#include "cirque/pipeline/certificate.h"
#include "cirque/pipeline/flat_surface.h"

namespace cirque {

/// Coherent angles, then log radii, for a job's targets on one triangulation, result's `intrinsic`:
/// fills in angles, multipliers and log radii, or the infeasibility with its proof, and the
/// certificate's summaries and times of both. `has_start`: the multipliers there are nearly the
/// solution's. What the dual cannot decide on the input's own connectivity, the interior point
/// does, where it takes the objective.
Status SolveFlatMetric(const FlattenJob& job, bool has_start, Certificate* certificate,
                       FlatSurface* result);

}  // namespace cirque

#pragma once

#include "cirque/core/status.h"
#include "cirque/pipeline/certificate.h"
#include "cirque/pipeline/flat_surface.h"

namespace cirque {

/// What an angle fit begins with.
enum class FitStart {
  kZero,            ///< multipliers of 0
  kMultipliers,     ///< those of the result, which are nearly the solution's
  kAfterWandering,  ///< multipliers of 0, where the dual has decided nothing on another
                    ///< triangulation for these targets: a small surface's are fitted by the
                    ///< interior point, where it takes the objective
};

/// Coherent angles, then log radii, for a job's targets on one triangulation, result's `intrinsic`:
/// fills in angles, multipliers and log radii, or the infeasibility with its proof, and the
/// certificate's summaries and times of both. Without angles there are no multipliers. What the
/// dual cannot decide on the input's own connectivity, the interior point does, where it takes the
/// objective.
Status SolveFlatMetric(const FlattenJob& job, FitStart start, Certificate* certificate,
                       FlatSurface* result);

/// Whether a step of the interior point costs less than one of the dual.
bool InteriorPointIsCheap(const Triangulation& triangulation);

}  // namespace cirque

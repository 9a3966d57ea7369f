#pragma once

#include "cirque/core/status.h"
#include "cirque/mesh/surface.h"

#include "experiments/run_experiment/run/carry_out.h"

namespace cirque {

/// Maps the surface to the run's domain with the run's method and measures the map: certificate
/// and, where the run keeps it, map of the result. `soup` is what the surface was made of. Stages
/// that the certificate has timed already keep their times.
Status MapRun(const PlannedRun& run, const PolygonSoup& soup, const Surface& surface,
              RunResult* result);

}  // namespace cirque

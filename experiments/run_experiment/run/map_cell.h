#pragma once

#include "cirque/core/status.h"
#include "cirque/mesh/surface.h"

#include "experiments/run_experiment/run/run_cell.h"

namespace cirque {

/// Maps the surface to the cell's domain with the cell's method and measures the map: certificate
/// and, where the cell keeps it, map of the result. `soup` is what the surface was made of. Stages
/// that the certificate has timed already keep their times.
Status MapCell(const Cell& cell, const PolygonSoup& soup, const Surface& surface,
               RunResult* result);

}  // namespace cirque

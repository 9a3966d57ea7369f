#pragma once

#include "cirque/metrics/metric.h"

namespace cirque {

/// The number of degenerate faces, which MappedFaces and with it all other figures leave out.
Metric Degenerate();

}  // namespace cirque

#pragma once

#include "cirque/core/registry.h"
#include "cirque/metrics/metric.h"

namespace cirque {

/// All metrics by name.
const Registry<Metric>& Metrics();

}  // namespace cirque

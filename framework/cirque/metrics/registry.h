#pragma once

#include "cirque/core/registry.h"
#include "cirque/metrics/distortion_measure.h"

namespace cirque {

/// All metrics by name.
const Registry<DistortionMeasure>& DistortionMeasures();

}  // namespace cirque

#pragma once

#include "cirque/metrics/distortion_measure.h"

namespace cirque {

/// a/A + A/a - 2 of every face, image and surface scaled to total area 1: 0 for an area-preserving
/// map. The maximum is the maximum area distortion of L. Shay, J. Solomon, O. Stein, A dataset and
/// benchmark for mesh parameterization, 2022.
DistortionMeasure AreaDistortion();

}  // namespace cirque

#pragma once

#include "cirque/metrics/distortion_measure.h"

namespace cirque {

/// |a - A| / A of every face, image and surface scaled to total area 1. Its mean weighted by area
/// on the surface, sum |a - A|, between 0 and 2, is the average area discrepancy of L. Shay, J.
/// Solomon, O. Stein, A dataset and benchmark for mesh parameterization, 2022.
DistortionMeasure AreaDiscrepancy();

}  // namespace cirque

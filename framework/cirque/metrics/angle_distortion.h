#pragma once

#include "cirque/metrics/distortion_measure.h"

namespace cirque {

/// s/t + t/s - 2 of every face, s and t the singular values: 0 for a conformal map. The maximum is
/// the maximum angle distortion of L. Shay, J. Solomon, O. Stein, A dataset and benchmark for mesh
/// parameterization, 2022.
DistortionMeasure AngleDistortion();

}  // namespace cirque

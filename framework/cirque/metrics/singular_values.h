#pragma once

#include "cirque/metrics/distortion_measure.h"

namespace cirque {

/// The smaller and the larger singular value of the differential of every face, image and surface
/// scaled to total area 1, and the least and the greatest of them, as in L. Shay, J. Solomon, O.
/// Stein, A dataset and benchmark for mesh parameterization, 2022. Those of flipped faces are
/// positive, too.
DistortionMeasure SmallerSingularValue();
DistortionMeasure LargerSingularValue();

}  // namespace cirque

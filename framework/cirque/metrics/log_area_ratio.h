#pragma once

#include "cirque/metrics/distortion_measure.h"

namespace cirque {

/// log(a / A) of every face, image and surface scaled to total area 1: twice the log scale factor,
/// the 2u of BFF (R. Sawhney, K. Crane, Boundary first flattening, ACM TOG 37(1), 2018). Minimum,
/// maximum, mean sum A log(a / A) and root mean square, weighted by area on the surface.
DistortionMeasure LogAreaRatio();

}  // namespace cirque

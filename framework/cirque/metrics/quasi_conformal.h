#pragma once

#include "cirque/metrics/distortion_measure.h"

namespace cirque {

/// sigma_max / sigma_min of every face, >= 1, and 1 everywhere for a conformal map: its mean,
/// median, 95th and 99th percentile weighted by area on the surface, and its maximum. (P. Sander,
/// J. Snyder, S. Gortler, H. Hoppe, Texture mapping progressive meshes, SIGGRAPH 2001, name the
/// singular values; the ratio is what the programs of R. Sawhney, K. Crane, Boundary first
/// flattening, ACM TOG 37(1), 2018, report.)
DistortionMeasure QuasiConformal();

}  // namespace cirque

#pragma once

#include "cirque/metrics/distortion_measure.h"

namespace cirque {

/// 1/2 (s^2 + t^2 + 1/s^2 + 1/t^2) of every face, s and t the singular values, image and surface
/// scaled to total area 1: 2 for an isometry, more otherwise. Its mean weighted by area on the
/// surface, and its maximum. (J. Smith, S. Schaefer, Bijective parameterization with free
/// boundaries, ACM TOG 34(4), 2015, without the 1/2; with it, and with singular values of flipped
/// faces taken positive: L. Shay, J. Solomon, O. Stein, A dataset and benchmark for mesh
/// parameterization, 2022.)
DistortionMeasure SymmetricDirichlet();

}  // namespace cirque

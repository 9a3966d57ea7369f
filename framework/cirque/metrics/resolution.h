#pragma once

#include "cirque/metrics/distortion_measure.h"

namespace cirque {

/// How many pixels the side of a square texture needs, that holds the image, so that every face has
/// at least one pixel per unit of length in every direction: 1 / sigma_min of every face for the
/// image scaled to the unit square (by its larger extent along the axes) and the surface scaled to
/// area 1. `resolution` is the maximum for the surface as it is, the measure of L. Shay, J.
/// Solomon, O. Stein, A dataset and benchmark for mesh parameterization, 2022; it grows with the
/// surface. `resolution_unit_area` is the maximum of the face values.
DistortionMeasure Resolution();

}  // namespace cirque

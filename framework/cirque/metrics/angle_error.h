#pragma once

#include "cirque/metrics/distortion_measure.h"

namespace cirque {

/// |angle in the plane - angle on the surface| [rad], of every face its mean over the three
/// corners: the mean weighted by area on the surface, and the maximum over all corners. Three times
/// the mean, sum A sum |difference|, is the average angle discrepancy of L. Shay, J. Solomon, O.
/// Stein, A dataset and benchmark for mesh parameterization, 2022 (who count 2 pi for each corner
/// of a face with a side of length zero; here such faces are left out).
DistortionMeasure AngleError();

}  // namespace cirque

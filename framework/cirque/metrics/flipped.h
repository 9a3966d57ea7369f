#pragma once

#include "cirque/metrics/distortion_measure.h"

namespace cirque {

/// 1 for every face that is clockwise in the plane, by an exact predicate, else 0. With their share
/// p among the measurable faces, min(p, 1 - p): a map that is mirrored throughout counts as none
/// flipped (L. Shay, J. Solomon, O. Stein, A dataset and benchmark for mesh parameterization,
/// 2022).
DistortionMeasure Flipped();

}  // namespace cirque

#pragma once

#include "cirque/metrics/distortion_measure.h"

namespace cirque {

/// The length on the surface, scaled to area 1, of the edges along which the map is torn: inner
/// edges whose ends have different UVs on their two sides, compared by value, each counted once (L.
/// Shay, J. Solomon, O. Stein, A dataset and benchmark for mesh parameterization, 2022).
DistortionMeasure CutLength();

}  // namespace cirque

#pragma once

#include "cirque/metrics/distortion_measure.h"

namespace cirque {

/// The number of degenerate faces, which MappedFaces and with it all other figures leave out.
DistortionMeasure Degenerate();

}  // namespace cirque

#pragma once

#include "cirque/metrics/distortion_measure.h"

namespace cirque {

/// The example of CONTRIBUTING.md: sqrt((s^2 + t^2) / 2), the root mean square stretch over all
/// directions (P. Sander, J. Snyder, S. Gortler, H. Hoppe, "Texture mapping progressive meshes",
/// SIGGRAPH 2001). The figure `l2_stretch` is its root mean square over the faces, by area: 1 for
/// an isometry, more for any other map.
DistortionMeasure L2Stretch();

}  // namespace cirque

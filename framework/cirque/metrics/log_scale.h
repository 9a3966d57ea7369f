#pragma once

#include "cirque/metrics/distortion_measure.h"

namespace cirque {

/// The log conformal factor u = 1/2 log(a / A) - c of every face, c such that its mean weighted by
/// area on the surface is zero: the scale of the image that makes the L2 norm least. The maximum of
/// |u| and the L2 norm sqrt(sum A u^2), as Y. Soliman, D. Slepcev, K. Crane, Optimal cone
/// singularities for conformal flattening, ACM TOG 37(4), 2018, and Q. Fang, W. Ouyang, M. Li, L.
/// Liu, X.-M. Fu, Computing sparse cones with bounded distortion for conformal parameterizations,
/// ACM TOG 40(6), 2021, measure the area distortion that cones leave.
DistortionMeasure LogScale();

}  // namespace cirque

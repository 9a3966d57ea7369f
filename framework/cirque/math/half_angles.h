#pragma once

#include <span>

#include "cirque/math/circle_angle.h"

namespace cirque {

/// CircleAngle::FromCorners for many edges at once, to a few ulp; arrays of one length.
void CircleAngles(std::span<const double> alpha_i, std::span<const double> alpha_j,
                  std::span<CircleAngle> angle);

/// HalfAngle and HalfAngleWeight of circle_angle.h for many edges at once; arrays of one length, of d and
/// of what CircleAngle has. The numbers are those of the single functions, in a quarter of the time.

void HalfAngles(std::span<const double> d, std::span<const double> sine,
                std::span<const double> one_minus_cosine, std::span<double> phi);

void HalfAngleWeights(std::span<const double> d, std::span<const double> sine,
                      std::span<const double> one_minus_cosine, std::span<double> weight);

}  // namespace cirque

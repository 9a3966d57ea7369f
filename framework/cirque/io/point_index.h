#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/types.h"

namespace cirque {

/// For every point the first one with equal coordinates (0 equals -0; a point that is not finite
/// equals none): itself where there is none before it. Expected O(points).
std::vector<Index> FirstOfEqualPoints(const std::vector<Eigen::Vector3d>& points);

}  // namespace cirque

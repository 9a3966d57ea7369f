#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/types.h"

namespace cirque {

/// The points' numbers in the order of a Hilbert curve whose cells are halved at medians, so that
/// neighbours in the order are near each other however uneven the points' density is. Equal
/// coordinates are ordered by number: the result is the same on every machine.
std::vector<Index> HilbertOrder(const std::vector<Eigen::Vector2d>& points);

}  // namespace cirque

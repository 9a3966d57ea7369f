#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/types.h"

namespace cirque {

/// Red, green and blue, each from 0 to 255.
using Colour = std::array<int, 3>;

/// Triangles, three corners each, as text PLY with a colour for every face; the comments, one line
/// each, stand in the header.
std::string FormatColouredPly(const std::vector<Eigen::Vector3d>& position,
                              const std::vector<Index>& corner, const std::vector<Colour>& colour,
                              const std::vector<std::string>& comments = {});

}  // namespace cirque

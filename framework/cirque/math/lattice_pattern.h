#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "cirque/math/unit_lattice.h"

namespace cirque {

/// The pattern that shows a lattice: it repeats by the lattice and goes into itself under the rotations
/// about its points. On squares a checkerboard, two of its squares along a unit, with the points in the middle
/// of dark ones; on triangles dark disks of radius 0.3 about the points. Returned is the distance to the
/// pattern's nearest edge, in units of the lattice, positive where it is dark, at most 0.3.
double PatternDistance(LatticeKind kind, const Eigen::Vector2d& point);

/// The two colours of the pattern: red, green, blue, from 0 to 1.
inline constexpr std::array<float, 3> kPatternDark = {0.24f, 0.42f, 0.62f},
                                      kPatternLight = {0.95f, 0.93f, 0.88f};

/// Places as coordinates of the lattice's periods, so that a period is a unit square, as pictures of
/// textures are.
Eigen::Vector2d InPeriods(LatticeKind kind, const Eigen::Vector2d& point);

/// The pattern over one period as `side` by `side` bytes, the first row of the lowest second coordinate:
/// clamp(1/2 + slope * PatternDistance) in 1/255, at the middle of each pixel (InPeriods).
std::vector<std::uint8_t> PatternTile(LatticeKind kind, int side, double slope);

}  // namespace cirque

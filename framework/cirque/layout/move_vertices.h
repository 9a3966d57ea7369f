#pragma once

#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/input_chart.h"

namespace cirque {

/// Rights mirrored faces of a flat metric by moving single vertices, each in the plane of its own
/// star: into the star's kernel, the points that see all its faces counter-clockwise, and there to
/// where the faces around it are least distorted (the objective mips of MapObjectives, Gauss-Newton
/// in one complex unknown). No angle sum changes but by whole turns, which mirrored faces can take
/// away, and no face outside the star. Of a mirrored face that vertex moves which leaves the least
/// distorted star.
///
/// `surface_angles`, `surface_lengths`: what shall be distorted little. `movable`, per vertex:
/// interior ones whose angles add up to 2 pi. Updates `flat`, whose list of mirrored faces then
/// holds those that no such move rights. Returns the number of moves.
int UntangleFlippedTriangles(const Triangulation& triangulation, const CornerAngles& surface_angles,
                             const EdgeLengths& surface_lengths, const std::vector<bool>& movable,
                             InputChart* flat);

}  // namespace cirque

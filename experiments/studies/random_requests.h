#pragma once

#include <string>

#include "cirque/domains/domain.h"
#include "cirque/mesh/surface.h"

#include "experiments/studies/small_surfaces.h"

namespace cirque {

/// Up to eight inner cones of any angle that Gauss-Bonnet allows; the boundary is free or has any angles
/// too.
ConeTargets DrawCones(const Triangulation& triangulation, Dice* dice);

/// Options drawn from the tables that know them, a domain, and at times angle sums near the limits
/// of the boundary's vertices: a map that somebody might ask for.
MapRequest DrawRequest(const Surface& surface, Dice* dice);

/// The request as flags of circle_patterns, "-domain=disk -epsilon=0.1"; angle sums, which are a file
/// there, as "angle sums".
std::string FlagsOf(const MapRequest& request);

}  // namespace cirque

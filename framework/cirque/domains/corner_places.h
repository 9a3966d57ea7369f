#pragma once

#include <complex>
#include <vector>

#include "cirque/core/status.h"
#include "cirque/domains/domain.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// Puts the corners of a map there and measures it. Refuses a map that comes out flipped with
/// kUnrepresentable, `because`.
Status PutCorners(const Surface& surface, const std::vector<std::complex<double>>& place,
                  const char* because, SurfaceMap* map);

/// Takes the cut away from a map of which every vertex has one place.
void ForgetCut(const Triangulation& triangulation, SurfaceMap* map);

}  // namespace cirque

#pragma once

#include "cirque/core/status.h"
#include "cirque/core/types.h"
#include "cirque/domains/domain.h"
#include "cirque/domains/map_options.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// What the options ask of a map of the surface, which was made of arrays with `num_vertices` points:
/// by their vertices, counted from 0. Errors (invalid input): vertices of no face, edges that are
/// none, cones given in two ways.
StatusOr<MapRequest> RequestOf(const MapOptions& options, Index num_vertices,
                               const Surface& surface);

}  // namespace cirque

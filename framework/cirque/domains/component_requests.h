#pragma once

#include <functional>
#include <vector>

#include "cirque/core/status.h"
#include "cirque/domains/domain.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// What is asked of a map of a surface, by the surface's own vertices and edges.
using SurfaceRequest = std::function<StatusOr<MapRequest>(const Surface&)>;

/// What is asked of a map of each component. The request is made once, of all components as one
/// surface (Joined); what it names finds the component that has it: of an option with several
/// vertices each gets its own, and one of which no cone and no cut is named is mapped as if none
/// were given.
StatusOr<std::vector<MapRequest>> RequestsOf(const SurfaceRequest& request,
                                             const std::vector<const Surface*>& components);

}  // namespace cirque

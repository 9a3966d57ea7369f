#pragma once

#include <vector>

#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/domains/domain.h"
#include "cirque/mesh/surface.h"

/// Meshes of several components: each is mapped by itself.
namespace cirque {

/// A component and what is asked of its map.
struct ComponentJob {
  const Surface& surface;
  MapRequest request;
  /// Which part of the file it is. The name of progress, and of its certificate's component where
  /// there are several jobs.
  ComponentSummary component = {};
};

/// What came of it: the map, or why there is none. The certificate is filled in either case.
struct MappedComponent {
  Status status;
  SurfaceMap map;
};

/// Maps every component by itself (MapSurface), several at once as threads allow, the largest
/// first. Results are in the jobs' order and do not depend on threads; infeasibility certificates
/// number vertices as the surface's soup, and name the component's triangles by its faces. The
/// control's callbacks are never called by two threads at once; its stages are led by "component 3
/// of 12, ", counted in the jobs' order, where there are several.
std::vector<MappedComponent> MapComponents(const std::vector<ComponentJob>& jobs,
                                           const SolveControl& control);

/// Several components' certificates as one: outcome and message are the worst (bad input,
/// infeasible, unrepresentable, not converged, inaccurate, ok), of the largest component that has
/// it; overlap the worst; counts, times and lengths of cuts are sums, errors maxima. Distortion is
/// left to be measured on all of them, and what is about one solve alone to the components.
Certificate SummarizeComponents(std::vector<Certificate> components);

}  // namespace cirque

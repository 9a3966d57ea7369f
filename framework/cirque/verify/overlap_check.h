#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "cirque/verify/uv_complex.h"

namespace cirque::verify {

/// How the UV boundary (the mesh's boundary and both sides of every seam) lies on itself. Touching
/// is allowed: only what makes two open pieces of the map cover the same points is found.
struct OverlapResult {
  Index num_boundary_edges = 0;
  Index num_boundary_loops = 0;
  std::vector<Index> wrapped_boundary;  ///< vertices with a boundary corner of more than 2 pi
  /// Two boundary halfedges that cross or lie on each other, or of which one lies in what the other
  /// bounds.
  std::optional<std::pair<Index, Index>> overlap;
  bool crosses = false;  ///< whether these two have a common point

  bool overlaps() const { return overlap || !wrapped_boundary.empty(); }
};

/// Decides exactly whether a map is injective (math/image_overlap.h, which the pipeline decides by
/// too: it asks nothing but coordinates). It must be locally injective: every triangle
/// counterclockwise, the triangles round every inner vertex turning once.
OverlapResult CheckOverlap(const UvComplex& complex);

}  // namespace cirque::verify

#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/types.h"

namespace cirque {

/// Triangles in the plane, glued: corners h = 3 f + k, side h from corner h to the next of its triangle.
struct ImageTriangles {
  const std::vector<Eigen::Vector2d>& uv;  ///< 3F
  const std::vector<Index>& twin;  ///< 3F: the side that side h is glued to; kNone: boundary
};

/// How the boundary of an image lies on itself. Touching is allowed: only what makes two open pieces
/// of the image cover the same points is found.
struct ImageOverlap {
  Index num_boundary_edges = 0;
  Index num_boundary_loops = 0;
  std::vector<Index> wrapped;  ///< boundary sides round whose begin the corners take more than 2 pi
  /// Two boundary sides that cross or lie on each other, or of which one lies in what the other
  /// bounds.
  std::optional<std::pair<Index, Index>> overlap;
  bool crosses = false;  ///< whether these two have a common point

  bool overlaps() const { return overlap || !wrapped.empty(); }
};

/// Decides exactly whether an image is injective, in O(n log n). It must be locally injective: every
/// triangle counterclockwise, the triangles round every inner vertex turning once.
///
/// Why the boundary decides: how many triangles cover a point off all edges is how often the
/// boundary of the patches, with the image on its left, winds about it, since inner edges cancel. So
/// the image is injective exactly where no winding number is above 1 (boundary_sweep.h).
ImageOverlap FindImageOverlap(const ImageTriangles& image);

}  // namespace cirque

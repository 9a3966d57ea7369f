#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cirque/core/status.h"
#include "cirque/verify/uv_complex.h"

namespace cirque::verify {

/// An edge by its vertices in IN, from 0.
using VertexPair = std::pair<Index, Index>;

/// How the two sides of the seams agree.
struct SeamAgreement {
  double largest_difference = kUnknown;  ///< relative, of the two lengths of one edge
  Index worst_halfedge = kNone;
  /// The largest difference [rad] of the rotation from one side of a seam to the other from a
  /// multiple of a full turn's `order`th part.
  double largest_rotation_gap = kUnknown;
  Index worst_rotation = kNone;  ///< a halfedge
};

/// Two sides in one patch must have one length and be turned by a multiple of 2 pi / order against
/// each other. Patches may have their own scales and directions: for sides in two patches the same
/// ratio, the median, and the same rotation, that of the first, are measured from. Without an order
/// (0) no rotation is.
SeamAgreement CompareSeams(const UvComplex& complex, int order);

/// What is asked of the seams.
struct SeamLimits {
  std::optional<Index> max_patches, max_edges;
  std::optional<std::vector<VertexPair>> edges;  ///< exactly these, all of them
  bool rigid = false;                            ///< both sides of equal lengths, by the tolerance
  int rotation_order = 0;  ///< rotations are multiples of 2 pi / this; 0: any will do
  double tolerance = 1e-6;
};

/// What is wrong with them.
std::vector<std::string> SeamErrors(const UvComplex& complex, const SeamAgreement& found,
                                    const SeamLimits& limits);

/// "1 patch, 27 seam edges", "torn: 18 patches of 1 component, 21 seam edges".
std::string SeamStatement(const UvComplex& complex);

/// Reads a file of edges, `from to` or `from to face` a line (an edge-cut file, which names a face
/// beside), numbers from 1; '#' begins a comment. Errors name file:line: not whole numbers, no such
/// vertex.
StatusOr<std::vector<VertexPair>> ReadEdges(const std::string& path, Index num_vertices);

}  // namespace cirque::verify

#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"

namespace cirque {

struct PackingOptions {
  bool rotate = true;  ///< each patch into its bounding rectangle of least area, either way round
  double gap = 1. / 256;  ///< between boxes, relative to the root of the boxes' total area; > 0
  bool to_unit_square = true;  ///< false: as large as they are
};

/// Patches side by side in a square.
struct Packing {
  CornerUv uv;                             ///< 3F, in [0, 1]^2 or [0, side]^2
  std::vector<Eigen::AlignedBox2d> boxes;  ///< per patch; they do not touch
  double scale = 1;                        ///< of all patches, so that areas stay comparable
};

/// Moves, rotates and scales the patches (all by the same factor, none mirrored) into a square at 0,
/// their boxes apart: one after the other, the longest first, each as low as it fits upon those
/// before and then as far left, lying or standing (the bottom-left heuristic on a skyline: B. Baker
/// et al., "Orthogonal packings in two dimensions", 1980); the width to fill is the best of several.
/// O(n (log n + s)) for a skyline of s steps, of which there are about the root of n.
/// @pre finite UVs.
Packing PackPatches(const CornerUv& uv, const Patches& patches, const PackingOptions& options);

/// The area of the image, what is flipped negative.
double AreaOf(const CornerUv& uv);

/// The share of their bounding square that the triangles of a map cover; those on one another count
/// again. 0 without triangles.
double AreaUsed(const CornerUv& uv);

/// The direction [rad] of a side of the bounding rectangle of least area, by rotating calipers
/// (G. Toussaint, "Solving geometric problems with the rotating calipers", 1983). 0 for points that
/// lie on no two lines.
double LeastRectangleDirection(std::vector<Eigen::Vector2d> points);

}  // namespace cirque

#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"

namespace cirque {

struct PackingOptions {
  bool rotate = true;     ///< each patch into its bounding rectangle of least area
  double gap = 1. / 256;  ///< between boxes, relative to the root of the boxes' total area; > 0
};

/// Patches side by side in the unit square.
struct Packing {
  CornerUv uv;                             ///< 3F, in [0, 1]^2
  std::vector<Eigen::AlignedBox2d> boxes;  ///< per patch; they do not touch
  double scale = 1;                        ///< of all patches, so that areas stay comparable
};

/// Moves, rotates and scales the patches (all by the same factor, none mirrored) into the unit
/// square, their boxes apart: on shelves, tallest first (the next-fit decreasing-height heuristic
/// of E. Coffman et al., "Performance bounds for level-oriented two-dimensional packing
/// algorithms", 1980), the shelf's width the best of several. A single patch is normalised to the
/// square. O(n log n).
/// @pre finite UVs.
Packing PackPatches(const CornerUv& uv, const Patches& patches, const PackingOptions& options);

/// The direction [rad] of a side of the bounding rectangle of least area, by rotating calipers
/// (G. Toussaint, "Solving geometric problems with the rotating calipers", 1983). 0 for points that
/// lie on no two lines.
double LeastRectangleDirection(std::vector<Eigen::Vector2d> points);

}  // namespace cirque

#pragma once

#include <vector>

#include "cirque/intrinsic/intrinsic_delaunay.h"

namespace cirque {

/// A flat metric brought back from an intrinsic triangulation towards the input's.
struct FlippedBack {
  Triangulation triangulation;  ///< the input's arrays when no edge is stuck
  EdgeLengths lengths;          ///< of the flat metric
  std::vector<Index> stuck;     ///< its edges that are none of the input's, increasing
};

/// Undoes the flips of `intrinsic` in reverse order in another metric: `flat` gives that metric's
/// lengths for the edges of intrinsic.triangulation. A flip is not undone when its two faces,
/// unfolded, are not strictly convex or are not those that it left behind because a later flip was
/// not undone; such edges stay and are listed. (L. Kharevych's thesis announces this step.)
FlippedBack FlipBack(const IntrinsicTriangulation& intrinsic, const EdgeLengths& flat);

}  // namespace cirque

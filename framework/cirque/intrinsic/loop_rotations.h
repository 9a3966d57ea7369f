#pragma once

#include <vector>

#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/dual_paths.h"

namespace cirque {

/// What directions shall turn by along a closed path (RotationAlong).
struct LoopRotation {
  DualPath path;
  double rotation = 0;  ///< [rad], modulo 2 pi
};

/// Rotations that a map shall have along loops of its surface's triangulation; no loops: any.
struct PrescribedRotations {
  std::vector<LoopRotation> loops = {};
  /// False: they are measured, and what the cones make of them is said. True: they are met, at the
  /// price of conformality (CloseRotations).
  bool meet = false;
};

/// The paths after flips (IntrinsicTriangulation::flips, from `input` on), each in its homotopy class of the
/// surface without its vertices: where it crossed a diagonal of two faces it crosses the other one, or
/// none. @pre closed paths that leave no face as they entered it.
std::vector<DualPath> PathsAfterFlips(const Triangulation& input, const std::vector<Index>& flips,
                                      std::vector<DualPath> paths);

}  // namespace cirque

#pragma once

#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"

namespace cirque {

/// A flat metric, solved on an intrinsic triangulation, as the triangles of the input have it when
/// their corners are joined by straight lines: the map that is linear on every input triangle.
struct InputChart {
  CornerAngles angles;          ///< 3F [rad]; of a mirrored triangle negative, with sum -pi
  EdgeLengths lengths;          ///< E
  std::vector<Index> mirrored;  ///< faces whose triangle is not positively oriented, increasing
};

/// Undoes the flips in reverse order with vectors instead of lengths: two faces are developed into
/// one frame, where the edge's other diagonal is a sum of two sides whether it lies inside their
/// quadrilateral or not. So the input's connectivity always comes back, at the price of triangles
/// that may be mirrored.
InputChart ReadOnInput(const Triangulation& input, const IntrinsicTriangulation& intrinsic,
                       const CornerAngles& flat_angles, const EdgeLengths& flat_lengths);

}  // namespace cirque

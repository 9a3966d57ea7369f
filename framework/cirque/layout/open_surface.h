#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// A surface opened along a cut, with the vectors that its edges are to have in the plane.
struct OpenSurface {
  Triangulation triangulation;  ///< of CutOpen
  Patches patches;
  Eigen::VectorXd direction;  ///< 3F [rad]: of every halfedge, in the frame of its patch
  EdgeLengths lengths;        ///< per edge of the opened triangulation

  /// The wanted vector of a halfedge, by the direction that its own face gives it.
  Eigen::Vector2d Wanted(Index h) const;
};

/// The lengths of a surface's edges as those of the surface opened, of the same halfedges.
EdgeLengths OpenedLengths(const Triangulation& triangulation, const EdgeLengths& lengths,
                          const Triangulation& open);

/// Opens the surface and gives every halfedge its direction: a sum of corner angles along the dual
/// tree of its patch, breadth first from the patch's first halfedge, which points along the x axis.
OpenSurface OpenWithDirections(const Triangulation& triangulation, const CornerAngles& flat_angles,
                               const EdgeLengths& lengths, const Cut& cut);

}  // namespace cirque

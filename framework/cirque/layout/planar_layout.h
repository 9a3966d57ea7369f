#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// A surface opened along a cut, with the target vectors of its edges in the plane.
struct OpenSurface {
  Triangulation triangulation;  ///< of CutOpen
  Patches patches;
  Eigen::VectorXd direction;  ///< 3F [rad]: of every halfedge, in the frame of its patch
  EdgeLengths lengths;        ///< per edge of the opened triangulation

  /// The target vector of a halfedge, by the direction that its own face gives it.
  Eigen::Vector2d TargetVector(Index h) const;

  /// Those of all edges, each of its edge_halfedge.
  std::vector<Eigen::Vector2d> TargetVectors() const;
};

/// The lengths of a surface's edges as those of the surface opened, of the same halfedges.
EdgeLengths OpenedLengths(const Triangulation& triangulation, const EdgeLengths& lengths,
                          const Triangulation& open);

/// Opens the surface and gives every halfedge its direction: a sum of corner angles along the dual
/// tree of its patch, breadth first from the patch's first halfedge, which points along the x axis.
OpenSurface OpenWithDirections(const Triangulation& triangulation, const CornerAngles& flat_angles,
                               const EdgeLengths& lengths, const Cut& cut);

/// Flat disks in the plane, each in a frame of its own, with how well they closed.
struct PlanarLayout {
  CornerUv uv;
  Patches patches;
  /// Per patch, max over its edges of |vector in the layout - target vector| / length.
  std::vector<double> patch_closure;
  double closure = 0;  ///< the largest of them
};

/// Lays out every patch of a flat surface opened along the cut, by edge directions: the direction
/// of every halfedge is a sum of corner angles along the dual tree, every vertex is placed along
/// the minimum spanning tree of the edge lengths by vectors of known length and direction. Errors
/// so add instead of multiplying, and vertices close to each other are joined by short edges. Each
/// patch's origin is put where its triangles are smallest, since doubles are densest there. A
/// vertex on the cut is placed once for every fan of corners that the cut leaves at it.
/// @pre every patch is a disk with flat vertices inside (CheckCut).
PlanarLayout LayOutPatches(const Triangulation& triangulation, const CornerAngles& flat_angles,
                           const EdgeLengths& lengths, const Cut& cut);

/// The same for a surface that is a flat disk as it is.
PlanarLayout LayOutByDirections(const Triangulation& triangulation, const CornerAngles& flat_angles,
                                const EdgeLengths& lengths);

/// The layout with the vertices of the opened surface at these positions; `target`: its
/// TargetVectors().
PlanarLayout LayoutAt(const OpenSurface& open, const std::vector<Eigen::Vector2d>& target,
                      const std::vector<Eigen::Vector2d>& position);

}  // namespace cirque

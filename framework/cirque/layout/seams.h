#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// A path of the cut from node to node. Nodes are the vertices on the boundary, the cones, and
/// those where the number of opened edges is not two; a path without nodes is closed. In the plane
/// its right side is its left side, moved: right = R(rotation) left + translation.
struct Seam {
  std::vector<Index> halfedges;  ///< those on its left, from its beginning to its end
  double rotation = 0;           ///< [rad], in [-pi, pi]
  Eigen::Vector2d translation = {0, 0};
};

/// The cut in the plane, and the evidence that a rigid motion leads across every path of it.
struct SeamReport {
  std::vector<Seam> seams;
  double max_length_mismatch = 0;    ///< over opened edges: |left - right| / the longer of the two
  double max_rotation_mismatch = 0;  ///< [rad]: rotation across an edge against that of its path
  /// Largest distance of a vertex on the right from where its path's motion takes the one on the
  /// left, relative to the diameter of all UVs.
  double max_gap = 0;
  /// [rad]: over interior vertices on the cut, the rotations across all paths around the vertex
  /// against minus its angle sum Theta, modulo 2 pi: what the cone's angle implies.
  double max_cone_mismatch = 0;
};

/// The seams of a layout. `flat_angles` give the angle sums Theta.
SeamReport MeasureSeams(const Triangulation& triangulation, const Cut& cut,
                        const std::vector<Index>& cones, const CornerAngles& flat_angles,
                        const CornerUv& uv);

/// Every seam's rotation as a multiple of 2 pi / order (order 4: cones of multiples of pi/2; 6: of
/// pi/3), in (-order/2, order/2]. Errors (invalid input): a rotation farther than `tolerance` [rad]
/// from all multiples, as around a handle or a loop of no such angle; the seam is named.
StatusOr<std::vector<int>> IntegerRotations(const Triangulation& triangulation,
                                            const SeamReport& report, int order, double tolerance);

/// The paths of a cut, without their motions.
std::vector<Seam> TraceSeams(const Triangulation& triangulation, const Cut& cut,
                             const std::vector<Index>& cones);

/// Moves UVs so that every seam's two sides differ by exactly the rotation multiple[i] 2 pi / order
/// and one translation, as far as doubles hold coordinates: the ends of all seams by the least
/// displacement that makes their motions agree (a small linear system over the nodes of the cut),
/// then the right side of every seam to where its left side is taken. Rotations of pi/2 are exact
/// in floating point. Returns the largest displacement of a UV; it is of the size of the gaps in
/// `report`, and triangles smaller than that should be checked again.
/// `multiple`: of IntegerRotations, one for every seam of `report`.
double SnapSeams(const Triangulation& triangulation, const Cut& cut, const SeamReport& report,
                 const std::vector<int>& multiple, int order, CornerUv* uv);

}  // namespace cirque

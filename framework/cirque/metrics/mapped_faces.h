#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/intrinsic_surface.h"

namespace cirque {

/// The faces of a piecewise linear map from a metric to the plane, measured once for all
/// distortion measures.
/// The map takes each Euclidean triangle with the given edge lengths to its uv triangle; surface
/// and image are each scaled to total area 1.
///
/// Only the measurable faces are here, M of them. A face without area on the surface has no
/// differential, one without area in the plane (exactly, or in doubles) no ratio of singular
/// values: such degenerate faces, and those with a uv that is not finite, are left out of every
/// figure and counted by `degenerate_faces`. So all numbers here are finite, and a figure is too,
/// unless there is no measurable face: then it is NaN.
struct MappedFaces {
  const Triangulation& triangulation;
  const EdgeLengths& lengths;
  const CornerUv& uv;

  std::vector<Index> face = {};       ///< the measurable faces, increasing
  Eigen::VectorXd area = {};          ///< A: on the surface, total 1
  Eigen::VectorXd image_area = {};    ///< a: in the plane, positive even where flipped, total 1
  Eigen::VectorXd sigma_max = {};     ///< larger singular value of the differential
  Eigen::VectorXd sigma_min = {};     ///< smaller one, > 0; sigma_max sigma_min = a / A
  Eigen::Matrix3Xd angle = {};        ///< corner angles on the surface [rad]
  Eigen::Matrix3Xd image_angle = {};  ///< in the plane [rad], positive even where flipped
  std::vector<bool> flipped = {};     ///< clockwise in the plane, exactly
  double surface_size = 0;            ///< square root of the surface's area, in the unit of lengths
  double image_size = 0;              ///< of the image's area, in the unit of uv
  Index num_faces() const { return static_cast<Index>(face.size()); }
};

/// `angles` are those of the surface, 3F, where they are known better than from its lengths, which
/// cannot tell the height of a very flat cap; null: from the lengths. The map must outlive the
/// result.
MappedFaces MeasureFaces(const Triangulation& triangulation, const EdgeLengths& lengths,
                         const CornerUv& uv, const CornerAngles* angles = nullptr);

/// The lengths of the edges as straight chords, E.
EdgeLengths ChordLengths(const Triangulation& triangulation,
                         const std::vector<Eigen::Vector3d>& position);

/// Every face with these edge lengths in a plane of its own, its first corner at the origin and its
/// second on the x axis: so a metric, too, can be the image that MeasureFaces looks at.
CornerUv FacesInPlane(const IntrinsicSurface& surface);

/// 3F: |angle in one metric - angle in the other| at every corner [rad].
Eigen::VectorXd AngleDifferences(const CornerAngles& from, const CornerAngles& to);

}  // namespace cirque

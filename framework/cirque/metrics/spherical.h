#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// The faces whose three points on the sphere do not turn counter-clockwise as seen from outside,
/// det[a, b, c] > 0, by exact arithmetic on the coordinates as they are. Increasing.
std::vector<Index> FlippedSphericalFaces(const Triangulation& triangulation,
                                         const std::vector<Eigen::Vector3d>& position);

/// How often the spherical triangles cover the sphere: their signed areas over 4 pi. A map without
/// flipped faces of degree 1 is injective.
double SphericalDegree(const Triangulation& triangulation,
                       const std::vector<Eigen::Vector3d>& position);

/// The lengths of the edges as straight chords.
EdgeLengths ChordLengths(const Triangulation& triangulation,
                         const std::vector<Eigen::Vector3d>& position);

/// Every face with these edge lengths in a plane of its own, the way MeasureFaces takes it.
CornerUv FacesInPlane(const Triangulation& triangulation, const EdgeLengths& lengths);

/// 3F: |angle in one metric - angle in the other| at every corner [rad].
Eigen::VectorXd AngleDifferences(const Triangulation& triangulation, const EdgeLengths& from,
                                 const EdgeLengths& to);

}  // namespace cirque

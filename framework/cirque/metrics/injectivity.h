#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// The flipped triangles: the faces whose uv triangle is not positively oriented, those without
/// area too, by exact arithmetic on the coordinates as they are. Increasing.
std::vector<Index> FlippedFaces(const Triangulation& triangulation, const CornerUv& uv);

/// The same once the coordinates are rounded to 32-bit floats, as many programs read them.
std::vector<Index> FlippedFacesInFloat32(const Triangulation& triangulation, const CornerUv& uv);

/// How boundary edges that share no vertex lie in the image.
enum class BoundaryContact {
  kApart,    ///< a map of a disk without flips is then injective
  kTouch,    ///< some touch or run along each other, none cross: opened seams can do so
  kCrossing  ///< some cross, so the image overlaps itself
};

/// The strongest contact, by exact arithmetic. Sorts by x and prunes: O(n log n) for n boundary
/// edges of which few lie one above the other, O(n^2) at worst.
BoundaryContact FindBoundaryContact(const Triangulation& triangulation, const CornerUv& uv);

/// The flipped triangles of a map to the sphere: the faces whose three points a, b, c do not turn
/// counter-clockwise as seen from outside, det[a, b, c] > 0, by exact arithmetic on the coordinates
/// as they are. Increasing.
std::vector<Index> FlippedSphericalFaces(const Triangulation& triangulation,
                                         const std::vector<Eigen::Vector3d>& position);

/// How often the spherical triangles cover the sphere: their signed areas over 4 pi, the area of a
/// triangle of unit vectors a, b, c being
///   2 atan2(det[a, b, c], 1 + a.b + b.c + c.a)
/// (A. Van Oosterom, J. Strackee, "The solid angle of a plane triangle", 1983). A map without
/// flipped triangles of degree 1 is injective.
double SphericalDegree(const Triangulation& triangulation,
                       const std::vector<Eigen::Vector3d>& position);

}  // namespace cirque

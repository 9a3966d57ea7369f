#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// The flipped triangles: the faces whose uv triangle is not positively oriented, those without
/// area and those whose coordinates overflowed too, by exact arithmetic on the coordinates as they
/// are. Increasing.
std::vector<Index> FlippedFaces(const Triangulation& triangulation, const CornerUv& uv);

/// The same once the coordinates are rounded to 32-bit floats, as many programs read them.
std::vector<Index> FlippedFacesInFloat32(const Triangulation& triangulation, const CornerUv& uv);

/// The inner vertices round which the triangles turn more than once, by exact comparisons. Steps of a
/// descent that flips no face can get there, since they need not be flip-free on their way.
/// Increasing. @pre no face is flipped; `triangulation` is the surface opened along its cut.
std::vector<Index> WoundVertices(const Triangulation& triangulation, const CornerUv& uv);

/// Whether the image covers some points more than once, exactly (math/image_overlap.h); touching is
/// no overlap. @pre no face is flipped, the faces round every inner vertex turn once; `triangulation`
/// is the surface opened along its cut.
bool OverlapsItself(const Triangulation& triangulation, const CornerUv& uv);

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

#pragma once

#include <Eigen/Core>

namespace cirque {

/// Exact signs (-1, 0, +1) of geometric determinants for any finite coordinates, subnormal and huge
/// ones included. A floating-point filter decides the common case; what it cannot decide is
/// computed in exact integers. NaN or infinite coordinates are a broken caller.
/// Error bounds of the filter: Shewchuk, Adaptive precision floating-point arithmetic and fast
/// robust geometric predicates, Discrete Comput. Geom. 18 (1997).

/// Sign of det[b - a, c - a]: +1 where a, b, c turn counter-clockwise, 0 where they are collinear.
int OrientationSign(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);

/// +1 where d lies strictly inside the circle through a, b, c in counter-clockwise order, 0 on it,
/// -1 outside; the sign is reversed for a clockwise triangle. For collinear a, b, c: the sign of
/// the same determinant of [x, y, x^2 + y^2] relative to d.
int InCircleSign(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                 const Eigen::Vector2d& d);

/// Sign of det[b - a, c - a, d - a]: +1 where d lies on the side of the plane a, b, c from which
/// the triangle is seen counter-clockwise, 0 where the four points are coplanar.
int OrientationSign3(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                     const Eigen::Vector3d& d);

}  // namespace cirque

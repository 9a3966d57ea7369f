#pragma once

#include <limits>

#include <Eigen/Core>

#include "cirque/math/plane_order.h"

namespace cirque::verify {

/// A number that was not found; reports leave it out.
inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// A point of the UV plane. Its two doubles are taken to mean exactly what they say.
using Point = Eigen::Vector2d;

/// Sign of the signed area of the triangle a b c: +1 counterclockwise, 0 collinear, -1 clockwise.
/// Exact for all finite doubles: floating point where its error bound decides (Shewchuk 1997, the
/// first stage of orient2d), rational arithmetic where not.
int Orientation(const Point& a, const Point& b, const Point& c);

}  // namespace cirque::verify

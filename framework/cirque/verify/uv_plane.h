#pragma once

#include <limits>

#include <Eigen/Core>

namespace cirque::verify {

/// A number that was not found; reports leave it out.
inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// A point of the UV plane. Its two doubles are taken to mean exactly what they say.
using Point = Eigen::Vector2d;

/// Sign of the signed area of the triangle a b c: +1 counterclockwise, 0 collinear, -1 clockwise.
/// Exact for all finite doubles: floating point where its error bound decides (Shewchuk 1997, the
/// first stage of orient2d), rational arithmetic where not.
int Orientation(const Point& a, const Point& b, const Point& c);

/// Whether a comes before b from left to right and, of one x, from below.
bool LexicographicallyLess(const Point& a, const Point& b);

/// Whether p lies strictly between a and b on their segment, exactly.
bool OnOpenSegment(const Point& p, const Point& a, const Point& b);

/// Whether a and b (both other than apex) lie on one ray from apex, exactly.
bool OnSameRay(const Point& apex, const Point& a, const Point& b);

/// The part of a neighbourhood of `apex` swept counterclockwise from the ray towards `from` to the
/// ray towards `to`, without these rays. Equal rays mean the full turn, not the empty one.
struct Sector {
  Point apex, from, to;
};

/// Whether the ray from the sector's apex to p (other than the apex) runs inside the sector.
bool Contains(const Sector& sector, const Point& p);

}  // namespace cirque::verify

#pragma once

#include <functional>
#include <vector>

#include "cirque/verify/uv_plane.h"

namespace cirque::verify {

/// What a polygon of the plane is, exactly.
enum class PolygonShape {
  kSimple,    ///< its border meets itself nowhere and runs counterclockwise
  kFlipped,   ///< the same, clockwise
  kZeroArea,  ///< all its corners lie on one line
  kFolded,    ///< anything else: it crosses or touches itself
};

/// Whether all points lie on one line, exactly.
bool IsOnOneLine(const std::vector<Point>& points);

/// O(n log n); O(n) for convex polygons. @pre three corners or more, all finite.
PolygonShape ShapeOf(const std::vector<Point>& polygon);

/// +1 where the corners i, j, k turn counterclockwise, 0 where they are straight, -1 clockwise.
using Turn = std::function<int(int, int, int)>;

/// Whether two corners lie at one point.
using Coincide = std::function<bool(int, int)>;

/// Triangles, three corners each, that fill a simple polygon of n corners without new ones: ears,
/// one after the other (G. Meisters, 1975). Where none is left, as in a polygon that is not simple,
/// empty. With `coincide` the polygon may touch itself at corners and along sides, as a keyhole does
/// that leads round a hole. O(n) for convex polygons, O(n r) steps with r corners that are not
/// convex.
std::vector<int> CutEars(int num_corners, const Turn& turn, const Coincide& coincide = {});

/// The fan (0, i, i + 1), which fills convex polygons only.
std::vector<int> CutFan(int num_corners);

}  // namespace cirque::verify

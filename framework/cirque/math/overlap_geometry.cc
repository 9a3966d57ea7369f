#include "cirque/math/overlap_geometry.h"

#include <algorithm>
#include <utility>

#include "cirque/math/predicates.h"

namespace cirque {
namespace {

using Eigen::Vector2d;

double Cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Whether a side of s has all of t on its outer side, exactly.
bool SideSeparates(const PlaneTriangle& s, const PlaneTriangle& t) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector2d &a = s[k], &b = s[(k + 1) % 3];
    const bool outside = std::all_of(
        t.begin(), t.end(), [&](const Vector2d& p) { return OrientationSign(a, b, p) <= 0; });
    if (outside) return true;
  }
  return false;
}

/// The parts to the left and to the right of the line from a to b.
struct Halves {
  ConvexPolygon left, right;
};

Halves Split(const ConvexPolygon& polygon, const Vector2d& a, const Vector2d& b) {
  Halves halves;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double at_p = Cross(b - a, p - a), at_q = Cross(b - a, q - a);
    if (at_p >= 0) halves.left.push_back(p);
    if (at_p <= 0) halves.right.push_back(p);
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) {
      const Vector2d crossing = p + at_p / (at_p - at_q) * (q - p);
      halves.left.push_back(crossing);
      halves.right.push_back(crossing);
    }
  }
  return halves;
}

}  // namespace

bool InteriorsMeet(const PlaneTriangle& s, const PlaneTriangle& t) {
  return !SideSeparates(s, t) && !SideSeparates(t, s);
}

double Area(const ConvexPolygon& polygon) {
  double twice = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    twice += Cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  }
  return twice / 2;
}

ConvexPolygon CutByTriangle(ConvexPolygon polygon, const PlaneTriangle& triangle,
                            std::vector<ConvexPolygon>* outside) {
  for (std::size_t k = 0; k < 3 && polygon.size() >= 3; ++k) {
    Halves halves = Split(polygon, triangle[k], triangle[(k + 1) % 3]);
    if (halves.right.size() >= 3) outside->push_back(std::move(halves.right));
    polygon = std::move(halves.left);
  }
  if (polygon.size() < 3) polygon.clear();
  return polygon;
}

}  // namespace cirque

#include "cirque/math/plane_order.h"

#include <algorithm>

#include "cirque/math/predicates.h"

namespace cirque {

using Eigen::Vector2d;

bool LexicographicallyLess(const Vector2d& a, const Vector2d& b) {
  return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

bool OnOpenSegment(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const auto& [low, high] = std::minmax(a, b, LexicographicallyLess);
  return LexicographicallyLess(low, p) && LexicographicallyLess(p, high) &&
         OrientationSign(a, b, p) == 0;
}

bool OnSameRay(const Vector2d& apex, const Vector2d& a, const Vector2d& b) {
  return LexicographicallyLess(apex, a) == LexicographicallyLess(apex, b) &&
         OrientationSign(apex, a, b) == 0;
}

bool IsInSector(const Sector& sector, const Vector2d& p) {
  const auto& [apex, from, to] = sector;
  if (OnSameRay(apex, from, to)) return !OnSameRay(apex, from, p);
  const int turn = OrientationSign(apex, from, to);
  const int after_from = OrientationSign(apex, from, p);
  const int before_to = OrientationSign(apex, p, to);
  if (turn > 0) return after_from > 0 && before_to > 0;
  if (turn == 0) return after_from > 0;
  // More than a half turn: everything but the closed sector from `to` on to `from`.
  return !(after_from <= 0 && before_to <= 0);
}

}  // namespace cirque

#include "cirque/verify/uv_plane.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <boost/multiprecision/cpp_int.hpp>

namespace cirque::verify {
namespace {

using Rational = boost::multiprecision::cpp_rational;

/// (a - c) x (b - c) for exact coordinates.
int ExactSign(const Rational& ax, const Rational& ay, const Rational& bx, const Rational& by,
              const Rational& cx, const Rational& cy) {
  const Rational area = (ax - cx) * (by - cy) - (ay - cy) * (bx - cx);
  return area.sign();
}

}  // namespace

bool LexicographicallyLess(const Point& a, const Point& b) {
  return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

int Orientation(const Point& a, const Point& b, const Point& c) {
  const double left = (a.x() - c.x()) * (b.y() - c.y());
  const double right = (a.y() - c.y()) * (b.x() - c.x());
  const double area = left - right;
  const double magnitude = std::abs(left) + std::abs(right);
  // Shewchuk's bound (3 + 16 u) u with u = 2^-53, which holds unless a product underflows; an
  // overflow makes one of the comparisons false.
  constexpr double kUnit = std::numeric_limits<double>::epsilon() / 2;
  constexpr double kBound = (3 + 16 * kUnit) * kUnit;
  constexpr double kNoUnderflow = 1e-280;
  if (magnitude > kNoUnderflow && std::abs(area) > kBound * magnitude) return area > 0 ? 1 : -1;
  return ExactSign(a.x(), a.y(), b.x(), b.y(), c.x(), c.y());
}

bool OnOpenSegment(const Point& p, const Point& a, const Point& b) {
  const auto& [low, high] = std::minmax(a, b, LexicographicallyLess);
  return LexicographicallyLess(low, p) && LexicographicallyLess(p, high) &&
         Orientation(a, b, p) == 0;
}

bool OnSameRay(const Point& apex, const Point& a, const Point& b) {
  return LexicographicallyLess(apex, a) == LexicographicallyLess(apex, b) &&
         Orientation(apex, a, b) == 0;
}

bool Contains(const Sector& sector, const Point& p) {
  const auto& [apex, from, to] = sector;
  if (OnSameRay(apex, from, to)) return !OnSameRay(apex, from, p);
  const int turn = Orientation(apex, from, to);
  const int after_from = Orientation(apex, from, p);
  const int before_to = Orientation(apex, p, to);
  if (turn > 0) return after_from > 0 && before_to > 0;
  if (turn == 0) return after_from > 0;
  // More than a half turn: everything but the closed sector from `to` on to `from`.
  return !(after_from <= 0 && before_to <= 0);
}

}  // namespace cirque::verify

#include "experiments/verify_map/exact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/multiprecision/cpp_int.hpp>

namespace cirque::verify_map {
namespace {

using Rational = boost::multiprecision::cpp_rational;

/// (a - c) x (b - c) for exact coordinates.
int ExactSign(const Rational& ax, const Rational& ay, const Rational& bx, const Rational& by,
              const Rational& cx, const Rational& cy) {
  const Rational area = (ax - cx) * (by - cy) - (ay - cy) * (bx - cx);
  return area.sign();
}

bool LexicographicallyLess(const Point& a, const Point& b) {
  return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

}  // namespace

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

bool Overlap(const Sector& a, const Sector& b) {
  // Where two arcs of a circle meet, what they share begins at the beginning of one of them.
  return OnSameRay(a.apex, a.from, b.from) || Contains(a, b.from) || Contains(b, a.from);
}

int RayCrossing(const Point (&triangle)[3], const Point& a, const Point& b) {
  const auto& [p, q, r] = triangle;
  const auto [low, high] = std::minmax({p.y(), q.y(), r.y()});
  if (std::max(a.y(), b.y()) < low || std::min(a.y(), b.y()) > high) return 0;
  if (std::max(a.x(), b.x()) < std::min({p.x(), q.x(), r.x()})) return 0;
  const Rational x = (Rational(p.x()) + Rational(q.x()) + Rational(r.x())) / 3;
  const Rational y = (Rational(p.y()) + Rational(q.y()) + Rational(r.y())) / 3;
  const bool upwards = Rational(a.y()) <= y && Rational(b.y()) > y;
  const bool downwards = Rational(a.y()) > y && Rational(b.y()) <= y;
  if (!upwards && !downwards) return 0;
  const int side = ExactSign(a.x(), a.y(), b.x(), b.y(), x, y);
  if (upwards) return side > 0 ? 1 : 0;
  return side < 0 ? -1 : 0;
}

}  // namespace cirque::verify_map

#include "cirque/verify/uv_plane.h"

#include <cmath>
#include <limits>

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

}  // namespace cirque::verify

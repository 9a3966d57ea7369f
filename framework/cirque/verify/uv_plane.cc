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

namespace {

std::vector<Index> GlueEqualUvs(const Surface& surface, const std::vector<Point>& uv) {
  std::vector<Index> glued(uv.size(), kNone);
  for (Index h = 0; h < static_cast<Index>(uv.size()); ++h) {
    const Index t = surface.twin[h];
    if (t == kNone) continue;
    if (uv[h] == uv[FanMesh::Next(t)] && uv[FanMesh::Next(h)] == uv[t]) glued[h] = t;
  }
  return glued;
}

/// Numbers the connected pieces in the order of their first triangles.
void LabelPatches(UvComplex* complex) {
  complex->patch.assign(complex->num_triangles(), kNone);
  std::vector<Index> stack;
  for (Index seed = 0; seed < complex->num_triangles(); ++seed) {
    if (complex->patch[seed] != kNone) continue;
    complex->patch[seed] = complex->num_patches;
    stack.push_back(seed);
    while (!stack.empty()) {
      const Index f = stack.back();
      stack.pop_back();
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        const Index g = complex->uv_twin[h] == kNone ? f : complex->uv_twin[h] / 3;
        if (complex->patch[g] != kNone) continue;
        complex->patch[g] = complex->num_patches;
        stack.push_back(g);
      }
    }
    ++complex->num_patches;
  }
}

}  // namespace

UvComplex BuildUvComplex(Surface surface, std::vector<Point> uv) {
  UvComplex complex;
  complex.uv_twin = GlueEqualUvs(surface, uv);
  complex.surface = std::move(surface);
  complex.uv = std::move(uv);
  LabelPatches(&complex);
  return complex;
}

Orientations ClassifyTriangles(const UvComplex& complex) {
  Orientations result;
  for (Index f = 0; f < complex.num_triangles(); ++f) {
    const int sign = Orientation(complex.uv[3 * f], complex.uv[3 * f + 1], complex.uv[3 * f + 2]);
    if (sign < 0) result.flipped.push_back(f);
    if (sign == 0) result.zero_area.push_back(f);
  }
  return result;
}

}  // namespace cirque::verify

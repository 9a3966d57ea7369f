#include "cirque/verify/polygon_check.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "cirque/math/boundary_sweep.h"

namespace cirque::verify {
namespace {

PolygonShape OfSign(int sign) {
  if (sign == 0) return PolygonShape::kZeroArea;
  return sign > 0 ? PolygonShape::kSimple : PolygonShape::kFlipped;
}

/// Whether the polygon turns left at every corner and once in all: then it is convex. Once: its
/// edges change only once from those that do not fall to those that do.
bool IsConvex(const std::vector<Point>& polygon) {
  const auto rises = [](const Point& a, const Point& b) {
    return b.y() > a.y() || (b.y() == a.y() && b.x() > a.x());
  };
  const std::size_t n = polygon.size();
  int changes = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % n], &c = polygon[(i + 2) % n];
    if (Orientation(a, b, c) <= 0) return false;
    changes += rises(a, b) != rises(b, c);
  }
  return changes == 2;
}

/// The turn of a simple polygon at its leftmost (of these, lowest) corner, where it is convex.
int Sense(const std::vector<Point>& polygon) {
  const auto leftmost = std::min_element(polygon.begin(), polygon.end(), LexicographicallyLess);
  const auto i = static_cast<std::size_t>(leftmost - polygon.begin()), n = polygon.size();
  return Orientation(polygon[(i + n - 1) % n], polygon[i], polygon[(i + 1) % n]);
}

}  // namespace

bool IsOnOneLine(const std::vector<Point>& polygon) {
  const auto other =
      std::find_if(polygon.begin(), polygon.end(), [&](const Point& p) { return p != polygon[0]; });
  return other == polygon.end() || std::all_of(polygon.begin(), polygon.end(), [&](const Point& p) {
           return Orientation(polygon[0], *other, p) == 0;
         });
}

PolygonShape ShapeOf(const std::vector<Point>& polygon) {
  const std::size_t n = polygon.size();
  if (n == 3) return OfSign(Orientation(polygon[0], polygon[1], polygon[2]));
  if (IsConvex(polygon)) return PolygonShape::kSimple;
  if (IsOnOneLine(polygon)) return PolygonShape::kZeroArea;
  std::vector<DirectedSegment> edges;
  for (std::size_t i = 0; i < n; ++i) {
    edges.push_back({polygon[i], polygon[(i + 1) % n]});
    if (edges.back().tail == edges.back().tip) return PolygonShape::kFolded;
  }
  if (FindOverlap(edges, Contacts::kEndsOnly)) return PolygonShape::kFolded;
  return OfSign(Sense(polygon));
}

namespace {

/// A ring of corners from which ears are cut.
class EarCutter {
 public:
  EarCutter(int n, const Turn& turn, const Coincide& coincide)
      : turn_(turn), coincide_(coincide), next_(n), previous_(n), reflex_(n) {
    for (int i = 0; i < n; ++i) {
      next_[i] = (i + 1) % n;
      previous_[i] = (i + n - 1) % n;
    }
    for (int i = 0; i < n; ++i) reflex_[i] = !TurnsLeft(i);
    for (int i = 0; i < n; ++i) {
      if (reflex_[i]) reflex_corners_.push_back(i);
    }
  }

  std::vector<int> Cut() {
    std::vector<int> triangles;
    auto left = static_cast<int>(next_.size());
    int at = 0;
    for (int tried = 0; left > 3 && tried < left;) {
      if (!IsEar(at)) {
        at = next_[at];
        ++tried;
        continue;
      }
      triangles.insert(triangles.end(), {previous_[at], at, next_[at]});
      at = Remove(at);
      --left;
      tried = 0;
    }
    if (left > 3 || !TurnsLeft(at)) return {};
    triangles.insert(triangles.end(), {previous_[at], at, next_[at]});
    return triangles;
  }

 private:
  bool TurnsLeft(int i) const { return turn_(previous_[i], i, next_[i]) > 0; }

  bool IsEar(int i) {
    if (!TurnsLeft(i)) return false;
    const int a = previous_[i], c = next_[i];
    std::erase_if(reflex_corners_, [&](int k) { return !reflex_[k]; });
    return std::none_of(reflex_corners_.begin(), reflex_corners_.end(), [&](int k) {
      return k != a && k != c && IsInWay(k, {a, i, c});
    });
  }

  /// Whether corner k lies in the closed triangle; at a corner of it, whether the border leaves k
  /// into the triangle.
  bool IsInWay(int k, const std::array<int, 3>& ear) const {
    for (int m = 0; coincide_ && m < 3; ++m) {
      if (!coincide_(k, ear[m])) continue;
      const int right = ear[(m + 1) % 3], left = ear[(m + 2) % 3];
      const auto inside = [&](int to) { return turn_(k, right, to) > 0 && turn_(k, to, left) > 0; };
      return inside(previous_[k]) || inside(next_[k]);
    }
    return turn_(ear[0], ear[1], k) >= 0 && turn_(ear[1], ear[2], k) >= 0 &&
           turn_(ear[2], ear[0], k) >= 0;
  }

  /// Takes a corner out of the ring; what it leaves at its sides may have become convex. Goes on
  /// two corners further, so that ears are cut from all sides and not a fan of slivers from one.
  int Remove(int i) {
    const int a = previous_[i], c = next_[i];
    next_[a] = c;
    previous_[c] = a;
    reflex_[i] = false;
    for (const int k : {a, c}) reflex_[k] = reflex_[k] && !TurnsLeft(k);
    return next_[c];
  }

  const Turn& turn_;
  const Coincide& coincide_;
  std::vector<int> next_, previous_;
  std::vector<char> reflex_;
  std::vector<int> reflex_corners_;
};

}  // namespace

std::vector<int> CutEars(int num_corners, const Turn& turn, const Coincide& coincide) {
  return EarCutter(num_corners, turn, coincide).Cut();
}

std::vector<int> CutFan(int num_corners) {
  std::vector<int> triangles;
  for (int i = 1; i + 1 < num_corners; ++i) triangles.insert(triangles.end(), {0, i, i + 1});
  return triangles;
}

}  // namespace cirque::verify

#include "cirque/mesh/ear_cutting.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

#include <Eigen/Geometry>

#include "cirque/math/predicates.h"

namespace cirque {
namespace {

using Polygon = std::span<const Eigen::Vector3d>;

using FlatPolygon = std::vector<Eigen::Vector2d>;

/// The polygon without the coordinate in which its normal is longest, counter-clockwise.
FlatPolygon AlongAxis(Polygon polygon, const Eigen::Vector3d& normal) {
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  const int u = (axis + (normal[axis] < 0 ? 2 : 1)) % 3,
            v = (axis + (normal[axis] < 0 ? 1 : 2)) % 3;
  FlatPolygon flat;
  for (const Eigen::Vector3d& x : polygon) flat.emplace_back(x[u], x[v]);
  return flat;
}

/// The polygon as it is seen along its normal, whose squares may be no numbers; rounded.
FlatPolygon AlongNormal(Polygon polygon, const Eigen::Vector3d& normal) {
  const Eigen::Vector3d unit = normal.stableNormalized(), x = unit.unitOrthogonal(),
                        y = unit.cross(x);
  FlatPolygon flat;
  for (const Eigen::Vector3d& p : polygon) {
    const Eigen::Vector3d from_first = p - polygon[0];
    flat.emplace_back(from_first.dot(x), from_first.dot(y));
  }
  return flat;
}

/// What decides which ear is cut first, and nothing of it depends on where the polygon begins.
struct Ear {
  double sharpness;
  Index tip, a, c;  ///< its corner and the ends of the diagonal
};

class EarCutter {
 public:
  EarCutter(Polygon polygon, FlatPolygon flat)
      : polygon_(polygon),
        flat_(std::move(flat)),
        size_(static_cast<Index>(polygon.size())),
        gone_(size_, false),
        queue_([this](const Ear& x, const Ear& y) { return IsBetter(y, x); }) {
    for (Index i = 0; i < size_; ++i) {
      next_.push_back((i + 1) % size_);
      prev_.push_back((i + size_ - 1) % size_);
    }
  }

  PolygonTriangles Cut() {
    PolygonTriangles triangles;
    for (Index i = 0; i < size_; ++i) {
      if (!TurnsLeft(i)) reflex_.push_back(i);
      Propose(i);
    }
    for (Index left = size_; left > 3; --left) {
      const Index tip = NextEar();
      if (tip == kNone) return {};
      triangles.push_back({prev_[tip], tip, next_[tip]});
      Remove(tip);
    }
    if (!TurnsLeft(last_)) return {};
    triangles.push_back({prev_[last_], last_, next_[last_]});
    return triangles;
  }

 private:
  bool IsBetter(const Ear& x, const Ear& y) const {
    if (x.sharpness != y.sharpness) return x.sharpness < y.sharpness;
    const Eigen::Vector3d* const of_x[] = {&polygon_[x.tip], &polygon_[x.a], &polygon_[x.c]};
    const Eigen::Vector3d* const of_y[] = {&polygon_[y.tip], &polygon_[y.a], &polygon_[y.c]};
    for (int k = 0; k < 2; ++k) {
      if (*of_x[k] != *of_y[k]) return ComesBefore(*of_x[k], *of_y[k]);
    }
    return ComesBefore(*of_x[2], *of_y[2]);
  }

  bool TurnsLeft(Index i) const {
    return OrientationSign(flat_[prev_[i]], flat_[i], flat_[next_[i]]) > 0;
  }

  /// Puts corner i among those that may be ears.
  void Propose(Index i) {
    if (!TurnsLeft(i)) return;
    const Index a = prev_[i], c = next_[i];
    queue_.push({Sharpness(polygon_[a], polygon_[i], polygon_[c]), i, a, c});
  }

  bool IsStale(const Ear& ear) const {
    return next_[ear.tip] != ear.c || prev_[ear.tip] != ear.a || gone_[ear.tip];
  }

  /// The best of the ears. Those that something stood in the way of are tried again when no other
  /// is left.
  Index NextEar() {
    bool again = true;
    while (true) {
      while (!queue_.empty()) {
        const Ear ear = queue_.top();
        queue_.pop();
        if (IsStale(ear)) continue;
        if (IsEar(ear.tip)) return ear.tip;
        blocked_.push_back(ear);
      }
      if (!again) return kNone;
      again = false;
      for (const Ear& ear : blocked_) queue_.push(ear);
      blocked_.clear();
    }
  }

  void Remove(Index tip) {
    const Index a = prev_[tip], c = next_[tip];
    next_[a] = c;
    prev_[c] = a;
    last_ = c;
    gone_[tip] = true;
    std::erase_if(reflex_, [&](Index k) { return gone_[k] || TurnsLeft(k); });
    Propose(a);
    Propose(c);
  }

  /// Whether the triangle at corner i, which turns left, holds no other part of the border, on its
  /// sides neither; copies of its own corners may lie there, if what they join leads away from it.
  bool IsEar(Index i) const {
    const Index a = prev_[i], c = next_[i];
    return std::none_of(reflex_.begin(), reflex_.end(), [&](Index k) {
      if (k == a || k == c) return false;
      const Eigen::Vector2d& x = flat_[k];
      if (x == flat_[a]) return LeadsInto(k, flat_[i], flat_[c]);
      if (x == flat_[i]) return LeadsInto(k, flat_[c], flat_[a]);
      if (x == flat_[c]) return LeadsInto(k, flat_[a], flat_[i]);
      return OrientationSign(flat_[a], flat_[i], x) >= 0 &&
             OrientationSign(flat_[i], flat_[c], x) >= 0 &&
             OrientationSign(flat_[c], flat_[a], x) >= 0;
    });
  }

  /// Whether the border leaves corner k between the directions to two points, the first on the
  /// right.
  bool LeadsInto(Index k, const Eigen::Vector2d& right, const Eigen::Vector2d& left) const {
    const auto inside = [&](Index to) {
      return OrientationSign(flat_[k], right, flat_[to]) > 0 &&
             OrientationSign(flat_[k], flat_[to], left) > 0;
    };
    return inside(prev_[k]) || inside(next_[k]);
  }

  const Polygon polygon_;
  const FlatPolygon flat_;
  const Index size_;
  std::vector<Index> next_, prev_;  ///< of the corners that are left
  std::vector<bool> gone_;
  std::vector<Index> reflex_;  ///< the corners left that do not turn left
  std::priority_queue<Ear, std::vector<Ear>, std::function<bool(const Ear&, const Ear&)>> queue_;
  std::vector<Ear> blocked_;
  Index last_ = 0;  ///< a corner that is left
};

}  // namespace

double Sharpness(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const auto cosine = [](const Eigen::Vector3d& x, const Eigen::Vector3d& y,
                         const Eigen::Vector3d& z) {
    return (y - x).stableNormalized().dot((z - x).stableNormalized());
  };
  constexpr double kDigits = 1e9;
  return std::round(kDigits * std::max({cosine(a, b, c), cosine(b, c, a), cosine(c, a, b)})) /
         kDigits;
}

bool ComesBefore(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

Eigen::Vector3d NewellNormal(Polygon polygon) {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    normal += (polygon[i - 1] - polygon[0]).cross(polygon[i] - polygon[0]);
  }
  return normal;
}

PolygonTriangles CutEars(Polygon polygon) {
  if (polygon.size() < 3) return {};
  const Eigen::Vector3d normal = NewellNormal(polygon);
  if (normal.isZero(0)) return {};
  PolygonTriangles ears = EarCutter(polygon, AlongAxis(polygon, normal)).Cut();
  return ears.empty() ? EarCutter(polygon, AlongNormal(polygon, normal)).Cut() : ears;
}

}  // namespace cirque

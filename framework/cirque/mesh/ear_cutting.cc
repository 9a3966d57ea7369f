#include "cirque/mesh/ear_cutting.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "cirque/math/predicates.h"

namespace cirque {
namespace {

using Polygon = std::span<const Eigen::Vector3d>;

/// The polygon without the coordinate in which its normal is longest, counter-clockwise.
std::vector<Eigen::Vector2d> Flattened(Polygon polygon) {
  const Eigen::Vector3d normal = NewellNormal(polygon);
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  const int u = (axis + (normal[axis] < 0 ? 2 : 1)) % 3,
            v = (axis + (normal[axis] < 0 ? 1 : 2)) % 3;
  std::vector<Eigen::Vector2d> flat;
  for (const Eigen::Vector3d& x : polygon) flat.emplace_back(x[u], x[v]);
  return flat;
}

/// The cosine of the least angle of a triangle: small for a good one.
double Sharpness(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const auto cosine = [](const Eigen::Vector3d& x, const Eigen::Vector3d& y,
                         const Eigen::Vector3d& z) {
    return (y - x).stableNormalized().dot((z - x).stableNormalized());
  };
  return std::max({cosine(a, b, c), cosine(b, c, a), cosine(c, a, b)});
}

class EarCutter {
 public:
  explicit EarCutter(Polygon polygon)
      : polygon_(polygon), flat_(Flattened(polygon)), size_(static_cast<Index>(polygon.size())) {
    for (Index i = 0; i < size_; ++i) {
      next_.push_back((i + 1) % size_);
      prev_.push_back((i + size_ - 1) % size_);
    }
  }

  PolygonTriangles Cut() {
    PolygonTriangles triangles;
    sharpness_.resize(size_);
    for (Index i = 0; i < size_; ++i) Judge(i);
    for (Index left = size_; left > 3; --left) {
      const auto best = std::min_element(sharpness_.begin(), sharpness_.end());
      if (*best >= kNoEar) return {};
      const auto tip = static_cast<Index>(best - sharpness_.begin());
      triangles.push_back({prev_[tip], tip, next_[tip]});
      next_[prev_[tip]] = next_[tip];
      prev_[next_[tip]] = prev_[tip];
      last_ = next_[tip];
      *best = kGone;
      Judge(prev_[tip]);
      Judge(next_[tip]);
    }
    if (OrientationSign(flat_[prev_[last_]], flat_[last_], flat_[next_[last_]]) <= 0) return {};
    triangles.push_back({prev_[last_], last_, next_[last_]});
    return triangles;
  }

 private:
  static constexpr double kNoEar = 2, kGone = 3;  ///< beyond every cosine

  void Judge(Index i) {
    sharpness_[i] =
        IsEar(i) ? Sharpness(polygon_[prev_[i]], polygon_[i], polygon_[next_[i]]) : kNoEar;
  }

  /// Whether the triangle at corner i turns left and holds no other corner, on its sides neither.
  bool IsEar(Index i) const {
    const Eigen::Vector2d &a = flat_[prev_[i]], &b = flat_[i], &c = flat_[next_[i]];
    if (OrientationSign(a, b, c) <= 0) return false;
    for (Index k = next_[next_[i]]; k != prev_[i]; k = next_[k]) {
      const Eigen::Vector2d& x = flat_[k];
      if (OrientationSign(a, b, x) >= 0 && OrientationSign(b, c, x) >= 0 &&
          OrientationSign(c, a, x) >= 0) {
        return false;
      }
    }
    return true;
  }

  const Polygon polygon_;
  const std::vector<Eigen::Vector2d> flat_;
  const Index size_;
  std::vector<Index> next_, prev_;  ///< of the corners that are left
  std::vector<double> sharpness_;
  Index last_ = 0;  ///< a corner that is left
};

}  // namespace

Eigen::Vector3d NewellNormal(Polygon polygon) {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    normal += (polygon[i - 1] - polygon[0]).cross(polygon[i] - polygon[0]);
  }
  return normal;
}

PolygonTriangles CutEars(Polygon polygon) {
  if (polygon.size() < 3 || NewellNormal(polygon).isZero(0)) return {};
  return EarCutter(polygon).Cut();
}

}  // namespace cirque

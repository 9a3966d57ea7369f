#include "cirque/layout/sphere_chart.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cirque {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// The least value below or at which half of the weight lies.
double WeightedMedian(const std::vector<double>& values, const std::vector<double>& weights) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  const double half = 0.5 * std::accumulate(weights.begin(), weights.end(), 0.0);
  double below = 0;
  for (const std::size_t i : order) {
    below += weights[i];
    if (below >= half) return values[i];
  }
  return values[order.back()];
}

/// Of Poincare's ball: the translation that takes 0 to y, at q.
Vector3d Translate(const Vector3d& y, const Vector3d& q) {
  const double yq = y.dot(q), yy = y.squaredNorm(), qq = q.squaredNorm();
  return ((1 + 2 * yq + qq) * y + (1 - yy) * q) / (1 + 2 * yq + yy * qq);
}

}  // namespace

Vector3d SphereChart::Lift(const Vector2d& z) const {
  const Vector2d w = (z - centre) / scale;
  const double size = std::hypot(w.x(), w.y());
  Vector3d point;
  if (size <= 1) {
    point << 2 * w, (1 - size) * (1 + size);
    return point / (1 + size * size);
  }
  // The same in u = w/|w|^2, so that far points neither overflow nor lose digits.
  const double inverse = 1 / size;
  point << 2 * inverse * (w * inverse), (inverse - 1) * (inverse + 1);
  return point / (1 + inverse * inverse);
}

SphereChart SphereChart::Recentred(const Vector3d& y) const {
  // Inversion in the sphere about infinity's image that meets the unit sphere in the equator takes
  // the ball to the upper half-space and the centre to (0, 0, 1).
  const Vector3d from_infinity = y - Infinity();
  const Vector3d point = Infinity() + (2 / from_infinity.squaredNorm()) * from_infinity;
  const double height = (1 - y.norm()) * (1 + y.norm()) / from_infinity.squaredNorm();
  return {centre + scale * point.head<2>(), scale * height};
}

SphereChart BalancedChart(const std::vector<Vector2d>& points, const std::vector<double>& weights) {
  SphereChart chart;
  std::vector<double> values(points.size());
  for (const int axis : {0, 1}) {
    std::transform(points.begin(), points.end(), values.begin(),
                   [axis](const Vector2d& z) { return z[axis]; });
    chart.centre[axis] = WeightedMedian(values, weights);
  }
  std::transform(points.begin(), points.end(), values.begin(),
                 [&](const Vector2d& z) { return (z - chart.centre).norm(); });
  chart.scale = WeightedMedian(values, weights);
  // Points of which half coincide, or a single one.
  if (!(chart.scale > 0)) chart.scale = *std::max_element(values.begin(), values.end());
  if (!(chart.scale > 0)) chart.scale = 1;
  return chart;
}

Vector3d CentreOfBoosts(const std::vector<Vector3d>& centres) {
  Vector3d point = Vector3d::Zero();
  for (auto centre = centres.rbegin(); centre != centres.rend(); ++centre) {
    point = Translate(*centre, point);
  }
  return point;
}

}  // namespace cirque

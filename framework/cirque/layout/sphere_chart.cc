#include "cirque/layout/sphere_chart.h"

#include <algorithm>
#include <array>
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

namespace {

using Eigen::Vector3d;

bool IsAtPole(const Vector3d& x) { return x.x() == 0 && x.y() == 0; }

double Latitude(const Vector3d& x) { return std::atan2(x.z(), std::hypot(x.x(), x.y())); }

/// The whole number that brings `turns` within 1/2 of `near`.
double WholeTurns(double turns, double near) { return std::nearbyint(near - turns); }

/// The u of three corners, each reached from the one before by the short way: the fraction of its
/// vertex, the same in all triangles, and a whole number. Returns false when they do not come back:
/// the triangle goes around a pole.
bool Unroll(const std::array<Vector3d, 3>& corner, std::array<double, 3>* u) {
  std::array<double, 3> turns, whole = {};
  std::vector<int> proper;
  for (int k = 0; k < 3; ++k) {
    turns[k] = std::atan2(corner[k].y(), corner[k].x()) / (2 * kPi) + 0.5;
    if (!IsAtPole(corner[k])) proper.push_back(k);
  }
  double least = 1;
  for (std::size_t i = 0; i < proper.size(); ++i) {
    const int k = proper[i], before = proper[i == 0 ? 0 : i - 1];
    whole[k] = WholeTurns(turns[k], turns[before] + whole[before]);
    least = std::min(least, turns[k] + whole[k]);
  }
  double mean = 0;
  for (const int k : proper) {
    (*u)[k] = turns[k] + (whole[k] - std::floor(least));
    mean += (*u)[k] / static_cast<double>(proper.size());
  }
  for (int k = 0; k < 3; ++k) {
    if (IsAtPole(corner[k])) (*u)[k] = mean;
  }
  if (proper.size() < 3) return true;
  return WholeTurns(turns[0], turns[2] + whole[2]) == whole[0];
}

}  // namespace

LatLong LatLongUv(const Triangulation& t, const std::vector<Vector3d>& position) {
  LatLong result;
  result.uv.value.resize(t.num_halfedges());
  for (Index h = 0; h < t.num_halfedges(); h += 3) {
    const std::array<Vector3d, 3> corner = {position[t.vertex[h]], position[t.vertex[h + 1]],
                                            position[t.vertex[h + 2]]};
    std::array<double, 3> u;
    if (!Unroll(corner, &u)) result.at_poles.push_back(Triangulation::Face(h));
    for (int k = 0; k < 3; ++k) {
      result.uv.value[h + k] = {u[k], Latitude(corner[k]) / kPi + 0.5};
    }
  }
  return result;
}

}  // namespace cirque

#include "cirque/generators/periodic_delaunay.h"

#include <algorithm>
#include <cmath>

#include "cirque/generators/surface_chart.h"

namespace cirque {
namespace {

/// How far around the cell translates are added, in mean distances of points: every circle that
/// decides about a triangle at the cell must lie within.
constexpr double kMargin = 10;

/// Points of the plane that cover a cell and a margin around it; the cell's own come first.
struct Covering {
  std::vector<Eigen::Vector2d> point;
  std::vector<Index> original;
};

Covering Cover(const std::vector<Eigen::Vector2d>& points, const Eigen::Vector2d& periods) {
  const double distance = std::sqrt(periods.prod() / static_cast<double>(points.size()));
  const Eigen::Vector2d reach =
      periods / 2 + periods.cwiseMin(Eigen::Vector2d::Constant(kMargin * distance));
  const auto count = static_cast<Index>(points.size());
  Covering covering{points, {}};
  for (Index v = 0; v < count; ++v) covering.original.push_back(v);
  for (Index v = 0; v < count; ++v) {
    for (int i = -1; i <= 1; ++i) {
      for (int j = -1; j <= 1; ++j) {
        const Eigen::Vector2d moved = points[v] + Eigen::Vector2d(i, j).cwiseProduct(periods);
        if ((i == 0 && j == 0) || (moved.cwiseAbs().array() > reach.array()).any()) continue;
        covering.point.push_back(moved);
        covering.original.push_back(v);
      }
    }
  }
  return covering;
}

}  // namespace

std::vector<Triangle> PeriodicDelaunay(const std::vector<Eigen::Vector2d>& points,
                                       const Eigen::Vector2d& periods) {
  const Covering covering = Cover(points, periods);
  const auto count = static_cast<Index>(points.size());
  std::vector<Triangle> representatives;
  for (const Triangle& triangle : TriangulateHull(covering.point)) {
    // Of the translates, the one whose least-numbered corner is the cell's own.
    const Index least = *std::min_element(triangle.begin(), triangle.end(), [&](Index i, Index j) {
      return covering.original[i] < covering.original[j];
    });
    if (least >= count) continue;
    Triangle& kept = representatives.emplace_back();
    std::transform(triangle.begin(), triangle.end(), kept.begin(),
                   [&](Index v) { return covering.original[v]; });
  }
  return representatives;
}

}  // namespace cirque

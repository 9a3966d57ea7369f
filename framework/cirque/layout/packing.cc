#include "cirque/layout/packing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <glog/logging.h>

#include "cirque/math/predicates.h"

namespace cirque {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

double Cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Adds to the hull the points in order that turn left (A. Andrew's monotone chain).
template <class Iterator>
void AddChain(Iterator first, Iterator last, std::vector<Vector2d>* hull) {
  const std::size_t begin = hull->size();
  for (; first != last; ++first) {
    while (hull->size() >= begin + 2 &&
           OrientationSign((*hull)[hull->size() - 2], hull->back(), *first) <= 0) {
      hull->pop_back();
    }
    hull->push_back(*first);
  }
  hull->pop_back();  // the other chain begins with it
}

/// Counter-clockwise, strictly convex.
std::vector<Vector2d> ConvexHull(std::vector<Vector2d> points) {
  std::sort(points.begin(), points.end(), [](const Vector2d& a, const Vector2d& b) {
    return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Vector2d> hull;
  AddChain(points.begin(), points.end(), &hull);
  AddChain(points.rbegin(), points.rend(), &hull);
  return hull;
}

struct Placed {
  Eigen::Matrix2d rotation;
  AlignedBox2d box;       // of the rotated patch
  Vector2d shelf_corner;  // where the box's lower corner goes
};

/// Lays the box down, so that shelves fit tight.
Placed Orient(const std::vector<Vector2d>& points, bool rotate) {
  Placed placed;
  const double angle = rotate ? -LeastRectangleDirection(points) : 0;
  placed.rotation = Eigen::Rotation2Dd(angle).toRotationMatrix();
  for (const Vector2d& p : points) placed.box.extend(Vector2d(placed.rotation * p));
  if (rotate && placed.box.sizes().x() < placed.box.sizes().y()) {
    Eigen::Matrix2d quarter;
    quarter << 0, -1, 1, 0;
    placed.rotation = (quarter * placed.rotation).eval();
    placed.box.setEmpty();
    for (const Vector2d& p : points) placed.box.extend(Vector2d(placed.rotation * p));
  }
  return placed;
}

/// Fills shelves of the given width; returns the side of the square that holds them.
double FillShelves(const std::vector<Index>& order, double width, double gap,
                   std::vector<Placed>* patches) {
  Vector2d corner(0, 0);
  double shelf_height = 0, used_width = 0;
  for (const Index i : order) {
    const Vector2d size = (*patches)[i].box.sizes();
    if (corner.x() > 0 && corner.x() + size.x() > width) {
      corner = {0, corner.y() + shelf_height + gap};
      shelf_height = 0;
    }
    (*patches)[i].shelf_corner = corner;
    used_width = std::max(used_width, corner.x() + size.x());
    shelf_height = std::max(shelf_height, size.y());
    corner.x() += size.x() + gap;
  }
  return std::max(used_width, corner.y() + shelf_height);
}

/// The side of the smallest square found.
double PackBoxes(double relative_gap, std::vector<Placed>* patches) {
  double area = 0, widest = 0;
  for (const Placed& p : *patches) {
    area += p.box.volume();
    widest = std::max(widest, p.box.sizes().maxCoeff());
  }
  const double least_width = std::max(std::sqrt(area), widest), gap = relative_gap * least_width;
  std::vector<Index> order(patches->size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
    return (*patches)[a].box.sizes().y() > (*patches)[b].box.sizes().y();
  });
  constexpr int kWidths = 32;
  double best_width = least_width, best_side = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kWidths; ++i) {
    const double width = least_width * (1 + static_cast<double>(i) / kWidths);
    const double side = FillShelves(order, width, gap, patches);
    if (side < best_side) best_width = width;
    best_side = std::min(side, best_side);
  }
  return FillShelves(order, best_width, gap, patches);
}

std::vector<std::vector<Vector2d>> PointsOfPatches(const CornerUv& uv, const Patches& patches) {
  std::vector<std::vector<Vector2d>> points(patches.count);
  for (std::size_t c = 0; c < uv.value.size(); ++c) {
    points[patches.of_face[c / 3]].push_back(uv.value[c]);
  }
  return points;
}

}  // namespace

double LeastRectangleDirection(std::vector<Vector2d> points) {
  const std::vector<Vector2d> hull = ConvexHull(std::move(points));
  const std::size_t n = hull.size();
  if (n < 2) return 0;
  const auto at = [&](std::size_t i) -> const Vector2d& { return hull[i % n]; };
  std::size_t right = 1, top = 1, left = 1;
  double best_area = std::numeric_limits<double>::infinity(), best = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2d along = (at(i + 1) - at(i)).normalized();
    const auto ahead = [&](std::size_t k) { return along.dot(at(k + 1) - at(k)); };
    const auto above = [&](std::size_t k) { return Cross(along, at(k + 1) - at(k)); };
    const std::size_t stop = i + n;
    right = std::max(right, i + 1);
    while (right < stop && ahead(right) > 0) ++right;
    top = std::max(top, right);
    while (top < stop && above(top) > 0) ++top;
    left = std::max(left, top);
    while (left < stop && ahead(left) < 0) ++left;
    const double area = along.dot(at(right) - at(left)) * Cross(along, at(top) - at(i));
    if (area < best_area) best = std::atan2(along.y(), along.x());
    best_area = std::min(best_area, area);
  }
  return best;
}

Packing PackPatches(const CornerUv& uv, const Patches& patches, const PackingOptions& options) {
  CHECK_GT(options.gap, 0);
  std::vector<Placed> placed;
  for (const auto& points : PointsOfPatches(uv, patches)) {
    placed.push_back(Orient(points, options.rotate));
  }
  const double side = PackBoxes(options.gap, &placed);
  // A little less than all of the square, so that rounding leads nothing out of it.
  constexpr double kInside = 1 - 1e-12;
  Packing packing;
  packing.scale = side > 0 ? kInside / side : 1;
  packing.boxes.resize(patches.count);
  packing.uv.value.reserve(uv.value.size());
  for (std::size_t c = 0; c < uv.value.size(); ++c) {
    const Index patch = patches.of_face[c / 3];
    const Placed& p = placed[patch];
    const Vector2d inside = p.rotation * uv.value[c] - p.box.min();
    packing.uv.value.push_back(packing.scale * (inside + p.shelf_corner));
    packing.boxes[patch].extend(packing.uv.value.back());
  }
  return packing;
}

}  // namespace cirque

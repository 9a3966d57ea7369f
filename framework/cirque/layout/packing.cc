#include "cirque/layout/packing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
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
  AlignedBox2d box;        // of the rotated patch
  Vector2d corner;         // where the lower corner goes of the box, turned or not
  bool is_turned = false;  // by a quarter more

  Vector2d Size(bool turned) const {
    const Vector2d size = box.sizes();
    return turned ? Vector2d(size.y(), size.x()) : size;
  }

  Vector2d Place(const Vector2d& p) const {
    const Vector2d inside = rotation * p - box.min();
    if (!is_turned) return corner + inside;
    return corner + Vector2d(box.sizes().y() - inside.y(), inside.x());
  }
};

Placed Orient(const std::vector<Vector2d>& points, bool rotate) {
  Placed placed;
  const double angle = rotate ? -LeastRectangleDirection(points) : 0;
  placed.rotation = Eigen::Rotation2Dd(angle).toRotationMatrix();
  for (const Vector2d& p : points) placed.box.extend(Vector2d(placed.rotation * p));
  return placed;
}

/// The upper border of what has been placed in a strip that is open above.
class Skyline {
 public:
  explicit Skyline(double width) : width_(width), steps_{{0, 0}} {}

  /// The lowest place for a box, the leftmost of equals; nothing where it is too wide.
  std::optional<Vector2d> Find(const Vector2d& size) const {
    std::optional<Vector2d> best;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      if (steps_[i].x + size.x() > width_) break;
      double y = steps_[i].y;
      for (std::size_t j = i + 1; j < steps_.size() && steps_[j].x < steps_[i].x + size.x(); ++j) {
        y = std::max(y, steps_[j].y);
      }
      if (!best || y < best->y()) best = Vector2d(steps_[i].x, y);
    }
    return best;
  }

  /// Puts a box where Find found room.
  void Add(const Vector2d& corner, const Vector2d& size) {
    const double end = corner.x() + size.x();
    std::size_t first = 0;
    while (steps_[first].x < corner.x()) ++first;
    std::size_t last = first;
    double y_behind = corner.y();
    while (last < steps_.size() && steps_[last].x < end) y_behind = steps_[last++].y;
    const bool goes_on = last < steps_.size() ? steps_[last].x > end : end < width_;
    const auto at = steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(first),
                                 steps_.begin() + static_cast<std::ptrdiff_t>(last));
    const auto box = steps_.insert(at, Step{corner.x(), corner.y() + size.y()});
    if (goes_on) steps_.insert(box + 1, Step{end, y_behind});
  }

 private:
  struct Step {
    double x, y;  // from x on to the next step's, or the strip's end
  };

  double width_;
  std::vector<Step> steps_;  // by x
};

/// Fills a strip of the given width; returns the side of the square that holds it.
double FillStrip(const std::vector<Index>& order, double width, double gap, bool turn,
                 std::vector<Placed>* patches) {
  const Vector2d gaps(gap, gap);
  Skyline skyline(width + gap);
  Vector2d used(0, 0);
  for (const Index i : order) {
    Placed& patch = (*patches)[i];
    double best_top = std::numeric_limits<double>::infinity();
    for (const bool turned : {false, true}) {
      if (turned && !turn) continue;
      const Vector2d size = patch.Size(turned);
      const std::optional<Vector2d> corner = skyline.Find(size + gaps);
      if (!corner || !(corner->y() + size.y() < best_top)) continue;
      best_top = corner->y() + size.y();
      patch.corner = *corner;
      patch.is_turned = turned;
    }
    skyline.Add(patch.corner, patch.Size(patch.is_turned) + gaps);
    used = used.cwiseMax(patch.corner + patch.Size(patch.is_turned));
  }
  return used.maxCoeff();
}

/// The side of the smallest square found.
double PackBoxes(const PackingOptions& options, std::vector<Placed>* patches) {
  double area = 0, widest = 0;
  for (const Placed& p : *patches) {
    area += p.box.volume();
    widest = std::max(widest, p.box.sizes().maxCoeff());
  }
  const double least_width = std::max(std::sqrt(area), widest), gap = options.gap * least_width;
  std::vector<Index> order(patches->size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
    return (*patches)[a].box.sizes().maxCoeff() > (*patches)[b].box.sizes().maxCoeff();
  });
  const int widths = patches->size() < 10000 ? 32 : 4;
  double best_width = least_width, best_side = std::numeric_limits<double>::infinity();
  for (int i = 0; i < widths; ++i) {
    const double width = least_width * (1 + 0.5 * i / widths);
    const double side = FillStrip(order, width, gap, options.rotate, patches);
    if (side < best_side) best_width = width;
    best_side = std::min(side, best_side);
  }
  return FillStrip(order, best_width, gap, options.rotate, patches);
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
  const double side = PackBoxes(options, &placed);
  // A little less than all of the square, so that rounding leads nothing out of it.
  constexpr double kInside = 1 - 1e-12;
  Packing packing;
  packing.scale = options.to_unit_square && side > 0 ? kInside / side : 1;
  packing.boxes.resize(patches.count);
  packing.uv.value.reserve(uv.value.size());
  for (std::size_t c = 0; c < uv.value.size(); ++c) {
    const Index patch = patches.of_face[c / 3];
    packing.uv.value.push_back(packing.scale * placed[patch].Place(uv.value[c]));
    packing.boxes[patch].extend(packing.uv.value.back());
  }
  return packing;
}

double AreaOf(const CornerUv& uv) {
  double area = 0;
  for (std::size_t h = 0; h < uv.value.size(); h += 3) {
    const Eigen::Vector2d a = uv.value[h + 1] - uv.value[h], b = uv.value[h + 2] - uv.value[h];
    area += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  return area;
}

double AreaUsed(const CornerUv& uv) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p : uv.value) box.extend(p);
  const double side = box.isEmpty() ? 0 : box.sizes().maxCoeff();
  return side > 0 ? AreaOf(uv) / (side * side) : 0;
}

}  // namespace cirque

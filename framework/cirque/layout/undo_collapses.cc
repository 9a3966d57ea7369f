#include "cirque/layout/undo_collapses.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "cirque/math/predicates.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;
using Point = Eigen::Vector2d;

constexpr int kHalvings = 200;  ///< on the way to a vertex; doubles have no more to offer

double Cross(const Point& a, const Point& b) { return a.x() * b.y() - a.y() * b.x(); }

Complex ToComplex(const Point& p) { return {p.x(), p.y()}; }

/// The minimiser of the least squares; nothing where no triangle has an area.
std::optional<Point> BestPlace(const CollapsedStar& star) {
  Complex moment = 0;
  double weight = 0;
  for (std::size_t k = 0; k < star.NumFaces(); ++k) {
    const Eigen::Vector3d &a = star.around()[k], &b = star.around()[star.Next(k)];
    const double length = a.norm(), doubled_area = a.cross(b).norm();
    if (!(doubled_area > 0)) continue;
    // The triangle flat, the vertex at 0 and the first side along the x axis.
    const Complex far(a.dot(b) / length, doubled_area / length), i(0, 1);
    const Complex hat = i * (far - length);
    const Complex sum =
        -i * far * ToComplex(star.ring()[k]) + i * length * ToComplex(star.ring()[star.Next(k)]);
    moment -= std::conj(hat) * sum / doubled_area;
    weight += std::norm(hat) / doubled_area;
  }
  if (!(weight > 0)) return std::nullopt;
  const Complex place = moment / weight;
  return Point(place.real(), place.imag());
}

/// What of a convex polygon lies on the left of the line from a to b.
void CutOff(const Point& a, const Point& b, std::vector<Point>* polygon) {
  std::vector<Point> left;
  for (std::size_t k = 0; k < polygon->size(); ++k) {
    const Point &p = (*polygon)[k], &q = (*polygon)[(k + 1) % polygon->size()];
    const double at_p = Cross(b - a, p - a), at_q = Cross(b - a, q - a);
    if (at_p >= 0) left.push_back(p);
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) {
      left.push_back(p + at_p / (at_p - at_q) * (q - p));
    }
  }
  *polygon = std::move(left);
}

/// A box about the ring, cut off along its sides; the mean of what is left.
Point MiddleOfKernel(const CollapsedStar& star) {
  Eigen::AlignedBox2d box;
  for (const Point& p : star.ring()) box.extend(p);
  if (!star.closed()) box = {box.min() - box.sizes(), box.max() + box.sizes()};
  std::vector<Point> kernel = {
      box.corner(Eigen::AlignedBox2d::BottomLeft), box.corner(Eigen::AlignedBox2d::BottomRight),
      box.corner(Eigen::AlignedBox2d::TopRight), box.corner(Eigen::AlignedBox2d::TopLeft)};
  for (std::size_t k = 0; k < star.NumFaces(); ++k)
    CutOff(star.ring()[k], star.ring()[star.Next(k)], &kernel);
  Point sum(0, 0);
  for (const Point& p : kernel) sum += p;
  return sum / static_cast<double>(kernel.size());  // NaN where nothing is left
}

/// From the fan's vertex between its outermost sides, half as long as the shorter; with an angle w
/// between them the directions in (max(0, w - pi), min(pi, w)) from the first lead into the kernel.
std::optional<Point> Inward(const CollapsedStar& star) {
  double whole = 0, first = 0, shortest = std::numeric_limits<double>::infinity();
  std::optional<Point> before;
  // Without the fan's vertex, which begins the ring or, on the boundary, may end it.
  for (const Point& p : star.ring()) {
    if (p == star.kept()) continue;
    const Point side = p - star.kept();
    if (before) {
      whole += std::atan2(Cross(*before, side), before->dot(side));
    } else {
      first = std::atan2(side.y(), side.x());
    }
    shortest = std::min(shortest, side.norm());
    before = side;
  }
  if (!before) return std::nullopt;
  double from = std::max(0., whole - kPi), to = std::min(kPi, whole);
  // Of a vertex on the boundary only one of the two sides bounds it.
  if (!star.closed()) {
    from = star.ring().front() == star.kept() ? 0 : whole - kPi;
    to = star.ring().front() == star.kept() ? kPi : whole;
  }
  const double direction = first + (from + to) / 2;
  return Point(shortest / 2 * Point(std::cos(direction), std::sin(direction)));
}

/// A point from which all is seen: the middle of the kernel, or one beside the fan's vertex.
std::optional<Point> PlaceInKernel(const CollapsedStar& star) {
  const Point middle = MiddleOfKernel(star);
  if (star.IsSeenFrom(middle)) return middle;
  const std::optional<Point> inward = Inward(star);
  if (!inward) return std::nullopt;
  double length = 1;
  for (int k = 0; k < kHalvings; ++k, length /= 2) {
    const Point place = star.kept() + length * *inward;
    if (star.IsSeenFrom(place)) return place;
  }
  return std::nullopt;
}

/// From a point that sees all as far towards another as that stays so, less a margin.
Point Towards(const CollapsedStar& star, const Point& seen, const Point& wanted) {
  constexpr double kMargin = 0.5;
  double share = kMargin;
  for (int k = 0; k < kHalvings; ++k, share /= 2) {
    const Point place = seen + share * (wanted - seen);
    if (star.IsSeenFrom(place)) return place;
  }
  return seen;
}

/// Where the vertex goes, and whether that is not its own best place.
std::optional<std::pair<Point, bool>> ChoosePlace(const CollapsedStar& star) {
  const std::optional<Point> best = BestPlace(star);
  if (best && star.IsSeenFrom(*best)) return {{*best, false}};
  const std::optional<Point> seen = PlaceInKernel(star);
  if (!seen) return std::nullopt;
  return {{best && best->allFinite() ? Towards(star, *seen, *best) : *seen, true}};
}

void TakeOffLast(CollapseLog* log) {
  log->removed.pop_back();
  log->kept.pop_back();
  log->first_face.pop_back();
  log->face.resize(log->first_face.back());
}

}  // namespace

StatusOr<Index> UndoCollapses(const std::vector<Eigen::Vector3d>& position, std::size_t count,
                              CollapseLog* log, CollapsedMap* map) {
  Index retreats = 0;
  for (; count > 0; --count) {
    CollapsedStar star(position, *log, map);
    const auto place = ChoosePlace(star);
    if (!place) {
      return Status(StatusCode::kUnrepresentable,
                    fmt::format("vertex {} does not fit between its neighbours in doubles",
                                log->removed.back() + 1));
    }
    star.Place(place->first);
    retreats += place->second;
    TakeOffLast(log);
  }
  return retreats;
}

}  // namespace cirque

#include "cirque/math/closed_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "cirque/math/boundary_sweep.h"

namespace cirque {
namespace {

using Eigen::Vector2d;

constexpr double kLargest = 1e140;  ///< of coordinates; 1 over it the least of sides

double Cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// With a bound of its rounding error.
struct SignedArea {
  double twice = 0, error = 0;
};

SignedArea MeasureArea(const std::vector<Vector2d>& point) {
  SignedArea area;
  double magnitude = 0;
  for (std::size_t k = 1; k + 1 < point.size(); ++k) {
    const Vector2d a = point[k] - point[0], b = point[k + 1] - point[0];
    area.twice += Cross(a, b);
    magnitude += std::abs(a.x() * b.y()) + std::abs(a.y() * b.x());
  }
  area.error =
      static_cast<double>(point.size() + 2) * std::numeric_limits<double>::epsilon() * magnitude;
  return area;
}

/// Squares of coordinates and of sides are to be numbers.
Status CheckSize(const std::vector<Vector2d>& point) {
  for (std::size_t k = 0; k < point.size(); ++k) {
    const Vector2d side = point[(k + 1) % point.size()] - point[k];
    if (point[k].lpNorm<Eigen::Infinity>() <= kLargest &&
        side.lpNorm<Eigen::Infinity>() >= 1 / kLargest) {
      continue;
    }
    return Status::InvalidInput(
        fmt::format("point {} of the curve is beyond {:g}, or its side is shorter than {:g}; scale "
                    "the curve to about 1",
                    k + 1, kLargest, 1 / kLargest));
  }
  return Status();
}

Status CheckPoints(const std::vector<Vector2d>& point) {
  if (point.size() < 3) return Status::InvalidInput("a closed curve has three points or more");
  for (std::size_t k = 0; k < point.size(); ++k) {
    if (!point[k].allFinite()) {
      return Status::InvalidInput(fmt::format("point {} of the curve is not finite", k + 1));
    }
    const Vector2d side = point[(k + 1) % point.size()] - point[k];
    if (side == Vector2d(0, 0)) {
      return Status::InvalidInput(
          fmt::format("points {} and {} of the curve are one", k + 1, (k + 1) % point.size() + 1));
    }
  }
  return CheckSize(point);
}

/// Sides are numbered as they were given, which may be the other way round.
Status CheckSimple(const std::vector<Vector2d>& point, bool reversed) {
  const auto n = static_cast<int>(point.size());
  std::vector<DirectedSegment> sides;
  for (int k = 0; k < n; ++k) sides.push_back({point[k], point[(k + 1) % n]});
  const auto meet = FindOverlap(sides, Contacts::kEndsOnly);
  if (!meet) return Status();
  const auto given = [&](int side) { return reversed ? n - side : side + 1; };
  const int a = given(meet->first), b = given(meet->second);
  return Status::InvalidInput(
      fmt::format("the curve meets itself: the sides that begin at its points {} and {} do",
                  std::min(a, b), std::max(a, b)));
}

}  // namespace

double AngleBetween(const Vector2d& from, const Vector2d& to) {
  return std::atan2(Cross(from, to), from.dot(to));
}

StatusOr<ClosedCurve> ClosedCurve::Through(std::vector<Vector2d> points) {
  if (points.size() > 3 && points.front() == points.back()) points.pop_back();
  if (Status s = CheckPoints(points); !s.ok()) return s;
  const SignedArea area = MeasureArea(points);
  if (area.twice < 0) std::reverse(points.begin() + 1, points.end());
  if (Status s = CheckSimple(points, area.twice < 0); !s.ok()) return s;
  if (!(std::abs(area.twice) > area.error)) {
    return Status::InvalidInput(
        "the curve encloses no area beyond rounding errors; draw it farther from a line");
  }
  return ClosedCurve(std::move(points));
}

ClosedCurve::ClosedCurve(std::vector<Vector2d> points) : point_(std::move(points)) {
  arc_.push_back(0);
  for (std::size_t k = 0; k < point_.size(); ++k) {
    arc_.push_back(arc_.back() + (point_[(k + 1) % point_.size()] - point_[k]).norm());
  }
}

double ClosedCurve::Area() const { return MeasureArea(point_).twice / 2; }

Vector2d ClosedCurve::At(double arc) const {
  const double on = arc - length() * std::floor(arc / length());
  const auto above = std::upper_bound(arc_.begin(), arc_.end() - 1, on);
  const auto k = static_cast<std::size_t>(above - arc_.begin()) - 1;
  const double side = arc_[k + 1] - arc_[k];  // 0 where one is too short beside the others
  const double share = side > 0 ? std::clamp((on - arc_[k]) / side, 0.0, 1.0) : 0;
  if (share == 0) return point_[k];
  return point_[k] + share * (point_[(k + 1) % point_.size()] - point_[k]);
}

double ClosedCurve::TurningAt(std::size_t k) const {
  const std::size_t n = point_.size();
  return AngleBetween(point_[k] - point_[(k + n - 1) % n], point_[(k + 1) % n] - point_[k]);
}

ClosedCurve Ellipse(double ratio, int points) {
  std::vector<Vector2d> point;
  for (int k = 0; k < points; ++k) {
    const double angle = 2 * std::numbers::pi * k / points;
    point.emplace_back(ratio * std::cos(angle), std::sin(angle));
  }
  return *ClosedCurve::Through(std::move(point));
}

}  // namespace cirque

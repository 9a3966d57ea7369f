#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/status.h"

namespace cirque {

/// A simple closed polygon of the plane as a curve, run through counter-clockwise from its first point.
class ClosedCurve {
 public:
  /// Points given clockwise are taken in reverse, the first one staying; the last one may be the first
  /// again. Errors (invalid input), points counted from 1: fewer than three, one that is not finite or
  /// lies where the one before does, sides that meet elsewhere than at their ends (decided exactly), sizes
  /// whose squares doubles do not hold, no area beyond its rounding error.
  static StatusOr<ClosedCurve> Through(std::vector<Eigen::Vector2d> points);

  double length() const { return arc_.back(); }
  double Area() const;
  const std::vector<Eigen::Vector2d>& points() const { return point_; }

  /// The arc length of every point from the first, and at last the curve's length.
  const std::vector<double>& arcs() const { return arc_; }

  /// The point at an arc length, any number: the curve closes.
  Eigen::Vector2d At(double arc) const;

  /// By how much the curve turns at a point, in (-pi, pi) [rad], counter-clockwise.
  double TurningAt(std::size_t point) const;

 private:
  explicit ClosedCurve(std::vector<Eigen::Vector2d> points);

  std::vector<Eigen::Vector2d> point_;
  std::vector<double> arc_;
};

/// The angle from one direction to another, in (-pi, pi].
double AngleBetween(const Eigen::Vector2d& from, const Eigen::Vector2d& to);

/// The ellipse of half axes `ratio` and 1 about 0 by `points` points of equal eccentric angles, from
/// (ratio, 0).
ClosedCurve Ellipse(double ratio, int points);

}  // namespace cirque

#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/math/closed_curve.h"

namespace cirque {

/// Polygons whose corners lie on a curve in its order, the first at the curve's beginning. Their shape:
/// the logarithm of the arc from every corner to the next, up to a constant.
class InscribedPolygons {
 public:
  explicit InscribedPolygons(const ClosedCurve& curve) : curve_(curve) {}

  /// The arc length of every corner, increasing from 0.
  std::vector<double> Arcs(const Eigen::VectorXd& shape) const;

  std::vector<Eigen::Vector2d> Corners(const std::vector<double>& arcs) const;

  /// The polygon's interior angles [rad], within [lower, upper] where the others can turn for those
  /// that cannot: what a corner lacks its neighbours turn, half each, and so on. They add up to (n - 2)
  /// pi. @pre n = lower.size() = upper.size() = shape.size() >= 3.
  Eigen::VectorXd Angles(const Eigen::VectorXd& shape, const Eigen::VectorXd& lower,
                         const Eigen::VectorXd& upper) const;

  /// By how much the log of the share that every side has of the polygon lies below that of `lengths`.
  Eigen::VectorXd Missing(const Eigen::VectorXd& shape, const Eigen::VectorXd& lengths) const;

  /// Moves the corner nearest to each of the curve's own corners there, of which none turns by less
  /// than pi/6, unless it is another one's already; the first stays. Returns which lie at one.
  std::vector<bool> MeetCorners(std::vector<double>* arcs) const;

 private:
  const ClosedCurve& curve_;
};

/// The corner from which a polygon turns most nearly as a curve does from its beginning: of 256 at most
/// that whose turning function is nearest to the curve's but for a rotation, in the mean square (E. Arkin,
/// L. Chew, D. Huttenlocher, K. Kedem, J. Mitchell, "An efficiently computable metric for comparing
/// polygonal shapes", IEEE PAMI 13, 1991). `lengths`: of the sides from every corner; `angles`: interior ones [rad].
int NearestStart(const ClosedCurve& curve, const Eigen::VectorXd& lengths,
                 const Eigen::VectorXd& angles);

}  // namespace cirque

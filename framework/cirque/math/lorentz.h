#pragma once

#include <Eigen/Core>

namespace cirque {

/// The Lorentz boost by a vector x of the open unit ball, acting on the unit sphere: a Moebius
/// transformation that fixes x/|x| and -x/|x| and moves everything from the former to the latter.
/// It carries the point x of Klein's ball to the centre; its inverse is the boost by -x.
///
/// With x4 = 1/sqrt(1 - x.x) and s = x4 x the light ray (v, 1) goes to
/// v' = v + ((v.s)/(x4+1) - 1) s, v4' = x4 - v.s, and the point is v'/v4'. That quotient cancels
/// for v near x/|x|; computed is the same map in Poincare's ball, which does not:
///   v -> (1 - y.y) (v - y)/|v - y|^2 - y,  y = x / (1 + sqrt(1 - x.x)).
/// The image is a unit vector to rounding.
///
/// Source: Springborn, A unique representation of polyhedral types, Math. Z. 249 (2005).
class LorentzBoost {
 public:
  /// |x| < 1; anything else is a broken caller.
  explicit LorentzBoost(const Eigen::Vector3d& x);

  /// The image of the unit vector v.
  Eigen::Vector3d operator()(const Eigen::Vector3d& v) const;

  /// y, the point of Poincare's ball that it carries to the centre: x at half its hyperbolic
  /// distance. On the equator, as complex numbers, the boost by a vector of the equator's plane is
  /// v -> (v - y) / (1 - conj(y) v).
  const Eigen::Vector3d& centre() const { return y_; }

 private:
  Eigen::Vector3d y_;
  double one_minus_y2_ = 1.0;  ///< 1 - y.y without cancellation
};

}  // namespace cirque

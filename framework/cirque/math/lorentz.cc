#include "cirque/math/lorentz.h"

#include <cmath>

#include <glog/logging.h>

namespace cirque {

LorentzBoost::LorentzBoost(const Eigen::Vector3d& x) {
  const double norm = x.norm();
  CHECK_LT(norm, 1.0) << "a Lorentz boost needs a vector inside the unit ball";
  const double root = std::sqrt((1.0 - norm) * (1.0 + norm));
  y_ = x / (1.0 + root);
  one_minus_y2_ = 2.0 * root / (1.0 + root);
}

Eigen::Vector3d LorentzBoost::operator()(const Eigen::Vector3d& v) const {
  const Eigen::Vector3d difference = v - y_;
  return ((one_minus_y2_ / difference.squaredNorm()) * difference - y_).normalized();
}

}  // namespace cirque

#pragma once

#include <deque>

#include <Eigen/Core>

namespace cirque {

/// Anderson's acceleration of a fixed-point iteration x <- G(x) (D. Anderson, J. ACM 12, 1965; H.
/// Walker, P. Ni, SIAM J. Numer. Anal. 49, 2011): the next x is what the last few pairs of x and
/// f = G(x) - x, combined so that f is least in the mean square, would lead to.
class AndersonMixing {
 public:
  explicit AndersonMixing(int depth) : depth_(depth) {}

  /// The next x.
  Eigen::VectorXd Next(const Eigen::VectorXd& x, const Eigen::VectorXd& f);

 private:
  int depth_;
  std::deque<Eigen::VectorXd> x_, f_;  ///< the last ones, the newest at the end
};

}  // namespace cirque

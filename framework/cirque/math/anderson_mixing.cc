#include "cirque/math/anderson_mixing.h"

#include <Eigen/QR>

namespace cirque {
namespace {

/// Directions that differ by less than this share are one: the iteration's own rounding.
constexpr double kIndependent = 1e-8;

}  // namespace

Eigen::VectorXd AndersonMixing::Next(const Eigen::VectorXd& x, const Eigen::VectorXd& f) {
  x_.push_back(x), f_.push_back(f);
  if (static_cast<int>(x_.size()) > depth_ + 1) x_.pop_front(), f_.pop_front();
  const auto pairs = static_cast<Eigen::Index>(x_.size()) - 1;
  if (pairs == 0) return x + f;
  Eigen::MatrixXd of_x(x.size(), pairs), of_f(x.size(), pairs);
  for (Eigen::Index k = 0; k < pairs; ++k) {
    of_x.col(k) = x_[k + 1] - x_[k];
    of_f.col(k) = f_[k + 1] - f_[k];
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factor(of_f);
  factor.setThreshold(kIndependent);
  return x + f - (of_x + of_f) * factor.solve(f);
}

}  // namespace cirque

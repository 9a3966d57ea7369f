#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/energy/energy.h"

namespace cirque {

/// The kinks of an energy as an orthant-wise Newton method treats them (after G. Andrew, J. Gao,
/// "Scalable training of L1-regularized log-linear models", ICML 2007): a parameter at its kink is
/// held there while zero lies between its two one-sided slopes, and no step leads across a kink.
class Kinks {
 public:
  explicit Kinks(const Energy& energy) : kinks_(energy.Kinks()) {}

  bool empty() const { return kinks_.empty(); }

  /// Makes the energy's gradient at x the subgradient of least norm: at a kink the one-sided slope
  /// along which the energy falls, 0 where it falls to neither side.
  void TakeLeastSubgradient(const Eigen::VectorXd& x, Eigen::VectorXd* gradient) const;

  /// Takes the parameters that x holds at a kink out of the Hessian: their rows and columns vanish
  /// but for the diagonal. `subgradient` is that of TakeLeastSubgradient at x.
  void Hold(const Eigen::VectorXd& x, const Eigen::VectorXd& subgradient,
            SparseMatrix* lower) const;

  /// Stops every parameter at its kink which in `trial` lies on another side of it than x does, or
  /// than the subgradient leads to from the kink.
  void StopAt(const Eigen::VectorXd& x, const Eigen::VectorXd& subgradient,
              Eigen::VectorXd* trial) const;

 private:
  const std::vector<Kink> kinks_;
};

}  // namespace cirque

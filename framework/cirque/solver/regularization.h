#pragma once

#include <vector>

#include "cirque/energy/energy.h"

namespace cirque {

/// What is added to a Hessian's diagonal before it is factored: a multiple of the identity that
/// adapts as in Levenberg and Marquardt, and at each gauge parameter once more its own diagonal
/// entry. The gradient being orthogonal to the gauge, the solution of that definite system is
/// exactly the step that leaves the gauge parameters alone.
class HessianShift {
 public:
  explicit HessianShift(const Energy& energy);

  /// Regularises a Hessian where it is.
  void Regularize(SparseMatrix* hessian);

  /// Raises the shift 100-fold, to at least 1e-5 of the mean diagonal. False when it is as high as
  /// makes sense.
  bool Raise();

  /// The same, and regularises the last Hessian anew.
  bool Raise(SparseMatrix* hessian);

  /// Lowers the shift after a full step, raises it after one below 1/100.
  void Adapt(double step_length);

  double shift() const { return shift_; }

 private:
  void Apply(SparseMatrix* hessian) const;

  const double least_;
  const std::vector<int> gauge_;
  double shift_;
  double scale_ = 1;          ///< mean diagonal entry of the last Hessian
  Eigen::VectorXd diagonal_;  ///< of the last Hessian as it was
};

}  // namespace cirque

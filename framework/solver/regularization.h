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

  /// The regularised matrix.
  const SparseMatrix& Apply(const SparseMatrix& lower);

  /// Raises the shift 100-fold, to at least 1e-5 of the mean diagonal. False when it is as high as
  /// makes sense.
  bool Raise();

  /// Lowers the shift after a full step, raises it after one below 1/100.
  void Adapt(double step_length);

  double shift() const { return shift_; }

 private:
  const double least_;
  const std::vector<int> gauge_;
  double shift_;
  double scale_ = 1;  ///< mean diagonal entry of the last Hessian
  SparseMatrix regularized_;
};

}  // namespace cirque

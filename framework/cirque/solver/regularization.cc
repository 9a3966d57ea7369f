#include "cirque/solver/regularization.h"

#include <algorithm>

#include "cirque/core/parallel.h"
#include "cirque/linear/sparse_matrix.h"

namespace cirque {
namespace {

constexpr double kRaise = 100, kLower = 0.01, kRaisedLeast = 1e-5, kMost = 1e8;
constexpr double kShortStep = 0.01, kFullStep = 0.99;

}  // namespace

HessianShift::HessianShift(const Energy& energy)
    : least_(energy.LeastHessianShift()), gauge_(energy.GaugeParameters()), shift_(least_) {}

void HessianShift::Regularize(SparseMatrix* hessian) {
  diagonal_ = Diagonal(*hessian);
  scale_ = diagonal_.size() > 0 ? diagonal_.mean() : 1;
  Apply(hessian);
}

void HessianShift::Apply(SparseMatrix* hessian) const {
  ParallelFor(static_cast<int>(diagonal_.size()),
              [&](int j) { DiagonalEntry(hessian, j) = diagonal_[j] + shift_; });
  for (const int g : gauge_) DiagonalEntry(hessian, g) *= 2;
}

bool HessianShift::Raise(SparseMatrix* hessian) {
  if (!Raise()) return false;
  Apply(hessian);
  return true;
}

bool HessianShift::Raise() {
  if (shift_ >= kMost * scale_) return false;
  shift_ = std::max(shift_ * kRaise, kRaisedLeast * scale_);
  return true;
}

void HessianShift::Adapt(double step_length) {
  if (step_length < kShortStep) {
    Raise();
  } else if (step_length > kFullStep) {
    shift_ = std::max(least_, shift_ * kLower);
    if (least_ == 0 && shift_ < 1e-12 * scale_) shift_ = 0;
  }
}

}  // namespace cirque

#include "cirque/solver/regularization.h"

#include <algorithm>

namespace cirque {
namespace {

constexpr double kRaise = 100, kLower = 0.01, kRaisedLeast = 1e-5, kMost = 1e8;
constexpr double kShortStep = 0.01, kFullStep = 0.99;

}  // namespace

HessianShift::HessianShift(const Energy& energy)
    : least_(energy.LeastHessianShift()), gauge_(energy.GaugeParameters()), shift_(least_) {}

const SparseMatrix& HessianShift::Apply(const SparseMatrix& lower) {
  regularized_ = lower;
  const int n = static_cast<int>(lower.cols());
  double trace = 0;
  for (int j = 0; j < n; ++j) {
    // The lower triangle of a column of a compressed symmetric matrix begins with its diagonal.
    double& diagonal = regularized_.valuePtr()[regularized_.outerIndexPtr()[j]];
    trace += diagonal;
    diagonal += shift_;
  }
  scale_ = n > 0 ? trace / n : 1;
  for (const int g : gauge_) {
    double& diagonal = regularized_.valuePtr()[regularized_.outerIndexPtr()[g]];
    diagonal += diagonal;
  }
  return regularized_;
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

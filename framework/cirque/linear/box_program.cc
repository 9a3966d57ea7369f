#include "cirque/linear/box_program.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <glog/logging.h>

#include "cirque/linear/registry.h"

namespace cirque {
namespace {

using Array = Eigen::ArrayXd;

constexpr int kMaxSteps = 80;
constexpr double kTowardsBound = 0.995;  ///< of the way to the first bound

/// The longest step, at most 1, that keeps value + step * change positive.
double LongestStep(const Array& value, const Array& change) {
  double step = 1;
  for (Eigen::Index i = 0; i < value.size(); ++i) {
    if (change[i] < 0) step = std::min(step, -kTowardsBound * value[i] / change[i]);
  }
  return step;
}

class InteriorPoint {
 public:
  explicit InteriorPoint(const BoxProgram& program)
      : program_(program),
        hessian_(program.hessian.selfadjointView<Eigen::Lower>()),
        x_(Array::Zero(program.linear.size())) {
    const double scale = program.linear.lpNorm<Eigen::Infinity>() + 1e-300;
    lower_ = upper_ = Array::Constant(x_.size(), scale);
  }

  BoxSolution Run(double tolerance) {
    BoxSolution solution;
    while (solution.factorizations < kMaxSteps) {
      solution.complementarity = Complementarity();
      if (solution.complementarity <= tolerance && EquationError() <= tolerance) {
        solution.converged = true;
        break;
      }
      if (!Step()) break;
      ++solution.factorizations;
    }
    solution.x = x_;
    solution.lower = lower_;
    solution.upper = upper_;
    return solution;
  }

 private:
  struct Direction {
    Array x, lower, upper;
  };

  Array ToLower() const { return program_.bound.array() + x_; }
  Array ToUpper() const { return program_.bound.array() - x_; }

  Array Residual() const {
    return (hessian_ * x_.matrix() - program_.linear).array() - lower_ + upper_;
  }

  double EquationError() const {
    return Residual().abs().maxCoeff() / program_.linear.lpNorm<Eigen::Infinity>();
  }

  double Complementarity() const {
    const double largest =
        std::max((lower_ * ToLower()).maxCoeff(), (upper_ * ToUpper()).maxCoeff());
    const double scale = program_.linear.lpNorm<Eigen::Infinity>() * program_.bound.maxCoeff();
    return largest / scale;
  }

  bool Factorize() {
    SparseMatrix matrix = program_.hessian;
    const Array barrier = lower_ / ToLower() + upper_ / ToUpper();
    for (Eigen::Index i = 0; i < x_.size(); ++i) {
      const auto k = static_cast<int>(i);
      matrix.coeffRef(k, k) += barrier[i];
    }
    return factor_->Factorize(matrix);
  }

  /// Newton's direction to products of multipliers and distances equal to `target_l`, `target_u`.
  Direction Solve(const Array& target_l, const Array& target_u) const {
    const Array to_lower = ToLower(), to_upper = ToUpper();
    const Array right =
        -Residual() + (target_l / to_lower - lower_) - (target_u / to_upper - upper_);
    Direction d;
    d.x = factor_->Solve(right.matrix()).array();
    d.lower = (target_l - lower_ * d.x) / to_lower - lower_;
    d.upper = (target_u + upper_ * d.x) / to_upper - upper_;
    return d;
  }

  bool Step() {
    if (!Factorize()) return false;
    const auto n = static_cast<double>(x_.size());
    const Array zero = Array::Zero(x_.size());
    const double mean = ((lower_ * ToLower()).sum() + (upper_ * ToUpper()).sum()) / (2 * n);
    const Direction affine = Solve(zero, zero);
    const double primal = PrimalStep(affine), dual = DualStep(affine);
    const Array lower = lower_ + dual * affine.lower, upper = upper_ + dual * affine.upper;
    const double reached = ((lower * (ToLower() + primal * affine.x)).sum() +
                            (upper * (ToUpper() - primal * affine.x)).sum()) /
                           (2 * n);
    const double target = mean * std::pow(reached / mean, 3);
    const Direction d = Solve(target - affine.lower * affine.x, target + affine.upper * affine.x);
    const double step_x = PrimalStep(d), step_dual = DualStep(d);
    x_ += step_x * d.x;
    lower_ += step_dual * d.lower;
    upper_ += step_dual * d.upper;
    return x_.allFinite() && lower_.allFinite() && upper_.allFinite();
  }

  double PrimalStep(const Direction& d) const {
    return std::min(LongestStep(ToLower(), d.x), LongestStep(ToUpper(), -d.x));
  }
  double DualStep(const Direction& d) const {
    return std::min(LongestStep(lower_, d.lower), LongestStep(upper_, d.upper));
  }

  const BoxProgram& program_;
  const SparseMatrix hessian_;
  const std::unique_ptr<SparseCholesky> factor_ = MakeCholesky();
  Array x_, lower_, upper_;
};

}  // namespace

BoxSolution SolveBoxProgram(const BoxProgram& program, double tolerance) {
  CHECK_EQ(program.linear.size(), program.bound.size());
  return InteriorPoint(program).Run(tolerance);
}

}  // namespace cirque

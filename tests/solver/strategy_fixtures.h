#pragma once

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "cirque/energy/energy.h"
#include "cirque/solver/solver_strategy.h"

namespace cirque {

/// 1/2 (x - minimiser)' A (x - minimiser) with the tridiagonal A = tridiag(-1, 2.5, -1).
class QuadraticEnergy final : public Energy {
 public:
  explicit QuadraticEnergy(Eigen::VectorXd minimiser) : minimiser_(std::move(minimiser)) {}

  int NumParameters() const override { return static_cast<int>(minimiser_.size()); }

  bool Evaluate(const double* x, double* value, double* gradient) const override {
    const Eigen::VectorXd offset = At(x) - minimiser_;
    const Eigen::VectorXd image = Matrix().selfadjointView<Eigen::Lower>() * offset;
    *value = 0.5 * offset.dot(image);
    if (gradient) Eigen::Map<Eigen::VectorXd>(gradient, image.size()) = image;
    return offset.allFinite();
  }

  bool Hessian(const double*, SparseMatrix* lower) const override {
    *lower = Matrix();
    return true;
  }

  const Eigen::VectorXd& minimiser() const { return minimiser_; }

 private:
  Eigen::Map<const Eigen::VectorXd> At(const double* x) const { return {x, minimiser_.size()}; }

  SparseMatrix Matrix() const {
    const auto n = static_cast<int>(minimiser_.size());
    SparseMatrix lower(n, n);
    for (int i = 0; i < n; ++i) {
      lower.insert(i, i) = 2.5;
      if (i + 1 < n) lower.insert(i + 1, i) = -1;
    }
    lower.makeCompressed();
    return lower;
  }

  Eigen::VectorXd minimiser_;
};

/// One parameter x in (-inf, 1): w log(1 + e^((x - c) / w)) - x / 2 - b log(1 - x). Its slope
/// saturates within w of c, and a wall stands at 1.
class WallEnergy final : public Energy {
 public:
  WallEnergy(double centre, double width, double barrier)
      : centre_(centre), width_(width), barrier_(barrier) {}

  int NumParameters() const override { return 1; }

  bool Evaluate(const double* x, double* value, double* gradient) const override {
    if (!(*x < 1)) return false;
    const double s = (*x - centre_) / width_;
    const double soft_plus = s > 0 ? s + std::log1p(std::exp(-s)) : std::log1p(std::exp(s));
    *value = width_ * soft_plus - 0.5 * *x - barrier_ * std::log1p(-*x);
    if (gradient) *gradient = Sigmoid(s) - 0.5 + barrier_ / (1 - *x);
    return true;
  }

  bool Hessian(const double* x, SparseMatrix* lower) const override {
    if (!(*x < 1)) return false;
    const double sigmoid = Sigmoid((*x - centre_) / width_);
    lower->resize(1, 1);
    lower->coeffRef(0, 0) = sigmoid * (1 - sigmoid) / width_ + barrier_ / ((1 - *x) * (1 - *x));
    lower->makeCompressed();
    return true;
  }

 private:
  static double Sigmoid(double s) { return 1 / (1 + std::exp(-s)); }

  double centre_, width_, barrier_;
};

/// The strategy of that name with those options, which must be right.
inline std::shared_ptr<const SolverStrategy> Strategy(const std::string& name,
                                                      const OptionMap& options = {}) {
  const auto strategy = MakeSolverStrategy(name, options);
  EXPECT_TRUE(strategy.ok()) << strategy.status().message();
  return *strategy;
}

}  // namespace cirque

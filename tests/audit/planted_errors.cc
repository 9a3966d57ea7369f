#include "tests/audit/planted_errors.h"

#include <cmath>
#include <vector>

#include <ceres/cost_function.h>

namespace cirque {
namespace {

/// How strongly a concave term bends.
constexpr double kBend = 1e4;

/// A cost function with the sign of the first Jacobian block's first entry turned around.
class TurnedJacobian final : public ceres::CostFunction {
 public:
  explicit TurnedJacobian(ceres::CostFunction* sound) : sound_(sound) {
    set_num_residuals(sound->num_residuals());
    *mutable_parameter_block_sizes() = sound->parameter_block_sizes();
  }

  bool Evaluate(double const* const* x, double* residuals, double** jacobians) const override {
    if (!sound_->Evaluate(x, residuals, jacobians)) return false;
    if (jacobians && jacobians[0]) jacobians[0][0] = -jacobians[0][0];
    return true;
  }

 private:
  std::unique_ptr<ceres::CostFunction> sound_;
};

}  // namespace

bool PlantedEnergy::Evaluate(const double* x, double* value, double* gradient) const {
  const bool inside = sound_->Evaluate(x, value, gradient);
  if (!inside) return error_ == PlantedError::kNoDomain;
  const int n = NumParameters(), last = n - 1;
  if (error_ == PlantedError::kGradientSign && gradient) gradient[last] = -gradient[last];
  if (error_ == PlantedError::kValueTerm) *value += 1e-3 * x[last];
  if (error_ == PlantedError::kValueConstant) *value += 1e-6;
  if (error_ == PlantedError::kNan) *value = std::nan("");
  if (error_ == PlantedError::kConcave) {
    *value -= 0.5 * kBend * x[last] * x[last];
    if (gradient) gradient[last] -= kBend * x[last];
  }
  return true;
}

bool PlantedEnergy::Gradient(const double* x, double* gradient) const {
  double value;
  if (!Evaluate(x, &value, gradient)) return false;
  if (error_ == PlantedError::kGradientAlone) gradient[0] += 1e-6;
  return true;
}

bool PlantedEnergy::Hessian(const double* x, SparseMatrix* lower) const {
  if (!sound_->Hessian(x, lower)) return error_ == PlantedError::kNoDomain;
  const int last = NumParameters() - 1;
  if (error_ == PlantedError::kConcave) lower->coeffRef(last, last) -= kBend;
  if (error_ == PlantedError::kHessianAsymmetric) lower->coeffRef(0, last) += 1e-3;
  if (error_ != PlantedError::kHessianSign) return true;
  for (int j = 0; j < lower->outerSize(); ++j) {
    for (SparseMatrix::InnerIterator entry(*lower, j); entry; ++entry) {
      if (entry.row() == j || entry.value() == 0) continue;
      entry.valueRef() = -entry.value();
      return true;
    }
  }
  return true;
}

void PlantedEnergy::AddResidualBlocks(double* x, ceres::Problem* problem) const {
  if (error_ != PlantedError::kResidualJacobian) return sound_->AddResidualBlocks(x, problem);
  ceres::Problem::Options options;
  options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem sound(options);
  sound_->AddResidualBlocks(x, &sound);
  std::vector<ceres::ResidualBlockId> blocks;
  sound.GetResidualBlocks(&blocks);
  for (const ceres::ResidualBlockId block : blocks) {
    std::vector<double*> parameters;
    sound.GetParameterBlocksForResidualBlock(block, &parameters);
    auto* function = const_cast<ceres::CostFunction*>(sound.GetCostFunctionForResidualBlock(block));
    if (block == blocks.front()) function = new TurnedJacobian(function);
    problem->AddResidualBlock(function, nullptr, parameters);
  }
}

}  // namespace cirque

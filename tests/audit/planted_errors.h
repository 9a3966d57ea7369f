#pragma once

#include <memory>
#include <utility>

#include "cirque/energy/energy.h"

namespace cirque {

/// What PlantedEnergy gets wrong.
enum class PlantedError {
  kNothing,
  kGradientSign,       ///< one entry of the gradient has the wrong sign
  kGradientAlone,      ///< Gradient() is not Evaluate's gradient
  kHessianSign,        ///< one off-diagonal entry has the wrong sign
  kHessianAsymmetric,  ///< an entry above the diagonal
  kConcave,            ///< minus a quadratic form, in value, gradient and Hessian alike
  kValueTerm,          ///< a term that the gradient does not know
  kValueConstant,      ///< a constant that no derivative sees
  kResidualJacobian,   ///< one Jacobian entry of the first residual block has the wrong sign
  kNoDomain,           ///< every point is accepted, NaN too
  kNan,                ///< NaN where the sound energy has a value
};

/// A sound energy with one planted error: what the audit must find.
class PlantedEnergy final : public Energy {
 public:
  PlantedEnergy(std::unique_ptr<const Energy> sound, PlantedError error)
      : sound_(std::move(sound)), error_(error) {}

  int NumParameters() const override { return sound_->NumParameters(); }
  bool Evaluate(const double* x, double* value, double* gradient) const override;
  bool Gradient(const double* x, double* gradient) const override;
  bool Hessian(const double* x, SparseMatrix* lower) const override;
  bool IsConvex() const override { return sound_->IsConvex(); }
  std::vector<int> GaugeParameters() const override { return sound_->GaugeParameters(); }
  double LeastDamping() const override { return sound_->LeastDamping(); }
  ResidualForm residual_form() const override { return sound_->residual_form(); }
  void AddResidualBlocks(double* x, ceres::Problem* problem) const override;

 private:
  std::unique_ptr<const Energy> sound_;
  PlantedError error_;
};

}  // namespace cirque

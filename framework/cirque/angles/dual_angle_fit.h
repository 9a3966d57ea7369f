#pragma once

#include <memory>
#include <utility>

#include "cirque/angles/angle_fit.h"
#include "cirque/solver/solver_strategy.h"

namespace cirque {

/// Minimises the Lagrange dual of the fit, which is convex and has no constraints, with any
/// strategy; takes every objective. Ranged angle sums make kinks, which the Newton strategies
/// treat; kInvalidInput with the others. The callback gets the multipliers.
class DualAngleFit final : public AngleFitMethod {
 public:
  explicit DualAngleFit(std::shared_ptr<const SolverStrategy> strategy)
      : strategy_(std::move(strategy)) {}
  Status Fit(const AngleFitProblem& problem, const std::shared_ptr<const AngleObjective>& objective,
             const SolveControl& control, AngleFitResult* result) const override;

 private:
  std::shared_ptr<const SolverStrategy> strategy_;
};

}  // namespace cirque

#include "cirque/angles/dual_angle_fit.h"

#include "cirque/angles/infeasibility.h"
#include "cirque/energy/dual_angle_energy.h"

namespace cirque {

Status DualAngleFit::Fit(const AngleFitProblem& problem,
                         const std::shared_ptr<const AngleObjective>& objective,
                         const SolveControl& control, AngleFitResult* result) const {
  const DualAngleEnergy energy(problem.constraints, problem.reference, problem.epsilon, objective);
  InfeasibilityWatch watch(problem.constraints, objective->Margin(problem.epsilon));
  const auto observe = [&](const IterationRecord& record, const Eigen::VectorXd& y) {
    if (control.callback && control.callback(record, y) == CallbackAction::kStop) {
      return CallbackAction::kStop;
    }
    return watch.Found(y) ? CallbackAction::kStop : CallbackAction::kContinue;
  };
  Eigen::VectorXd y =
      problem.start ? *problem.start : Eigen::VectorXd::Zero(energy.NumParameters()).eval();
  result->solve = strategy_->Minimize(energy, {observe, control.cancelled}, &y);
  if (result->solve.termination == Termination::kUnsupported) {
    return Status::InvalidInput("angle fit: " + result->solve.message);
  }
  Eigen::VectorXd alpha = energy.Angles(y.data());
  return FinishFit(problem, *objective, watch.proof(), std::move(alpha), std::move(y), result);
}

}  // namespace cirque

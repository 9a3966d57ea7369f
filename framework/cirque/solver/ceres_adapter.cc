#include "cirque/solver/ceres_adapter.h"

#include <cmath>
#include <utility>

namespace cirque {
namespace {

constexpr double kRounding = 1e-14;  ///< relative changes of the value below this are noise
constexpr double kClearlySmaller = 0.5;

double MaxNorm(const Eigen::VectorXd& v) { return v.lpNorm<Eigen::Infinity>(); }

}  // namespace

CeresWatch::CeresWatch(SolveRun* run, GradientFunction gradient_at, PointFunction accepted,
                       const Eigen::VectorXd& gradient, int max_idle, Eigen::VectorXd* x)
    : run_(run),
      gradient_at_(std::move(gradient_at)),
      accepted_(std::move(accepted)),
      gradient_(gradient),
      x_(x),
      max_idle_(max_idle),
      best_(MaxNorm(gradient)),
      best_x_(*x),
      best_gradient_(gradient) {}

ceres::CallbackReturnType CeresWatch::operator()(const ceres::IterationSummary& summary) {
  const bool is_new = summary.iteration > 0 && summary.step_is_successful;
  const bool goes_on = !is_new || Take(summary);
  return goes_on && run_->Continue(gradient_) && !round_ends_
             ? ceres::SOLVER_CONTINUE
             : ceres::SOLVER_TERMINATE_SUCCESSFULLY;
}

bool CeresWatch::Take(const ceres::IterationSummary& summary) {
  Eigen::VectorXd point = accepted_(), gradient;
  if (!gradient_at_(point, &gradient)) {
    round_ends_ = true;
    return true;
  }
  gradient_ = std::move(gradient);
  *x_ = std::move(point);
  const double step_length = summary.step_size > 0 ? summary.step_size : 1;
  if (!run_->Accept(*x_, gradient_, step_length, summary.cost)) return false;
  if (MaxNorm(gradient_) < best_) {
    KeepBest();
  } else if (std::abs(summary.cost_change) <= kRounding * std::abs(summary.cost) &&
             ++idle_ >= max_idle_) {
    round_ends_ = true;
  }
  return true;
}

void CeresWatch::KeepBest() {
  best_ = MaxNorm(gradient_);
  best_x_ = *x_;
  best_gradient_ = gradient_;
  idle_ = 0;
}

void CeresWatch::BeginRound() {
  round_ends_ = is_round_asked_ = false;
  idle_ = 0;
  round_start_ = best_;
}

void CeresWatch::Offer(const Eigen::VectorXd& point) {
  Eigen::VectorXd gradient;
  if (run_->summary().termination != Termination::kNotRun || !gradient_at_(point, &gradient)) {
    return;
  }
  if (MaxNorm(gradient) > kClearlySmaller * best_) return;
  *x_ = point;
  gradient_ = std::move(gradient);
  KeepBest();
  if (run_->Accept(*x_, gradient_, 1)) run_->Continue(gradient_);
}

bool CeresWatch::AnotherRoundHelps(const std::string& message) {
  if (run_->summary().termination != Termination::kNotRun) return false;
  if (is_round_asked_) return true;
  *x_ = best_x_;
  gradient_ = best_gradient_;
  if (best_ < kClearlySmaller * round_start_) return true;
  run_->summary().final_gradient_max = best_;
  run_->End(Termination::kStalled, "no step improves x in floating point; Ceres: " + message);
  return false;
}

}  // namespace cirque

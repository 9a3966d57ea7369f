#include "cirque/solver/ceres_adapter.h"

#include <cmath>
#include <utility>

namespace cirque {
namespace {

constexpr double kRounding = 1e-14;  ///< relative changes of the value below this are noise
constexpr int kMaxIdle = 5;
constexpr double kClearlySmaller = 0.5;

double MaxNorm(const Eigen::VectorXd& v) { return v.lpNorm<Eigen::Infinity>(); }

}  // namespace

CeresWatch::CeresWatch(SolveRun* run, GradientFunction gradient_at, const Eigen::VectorXd* accepted,
                       const Eigen::VectorXd& gradient, Eigen::VectorXd* x)
    : run_(run),
      gradient_at_(std::move(gradient_at)),
      accepted_(accepted),
      gradient_(gradient),
      x_(x),
      best_(MaxNorm(gradient)),
      best_x_(*x) {}

ceres::CallbackReturnType CeresWatch::operator()(const ceres::IterationSummary& summary) {
  const bool is_new = summary.iteration > 0 && summary.step_is_successful;
  const bool goes_on = !is_new || Take(summary);
  return goes_on && run_->Continue(gradient_) && !round_ends_
             ? ceres::SOLVER_CONTINUE
             : ceres::SOLVER_TERMINATE_SUCCESSFULLY;
}

bool CeresWatch::Take(const ceres::IterationSummary& summary) {
  Eigen::VectorXd gradient;
  if (!gradient_at_(*accepted_, &gradient)) {
    Stall("Ceres stepped out of the energy's domain");
    return false;
  }
  gradient_ = std::move(gradient);
  *x_ = *accepted_;
  const double step_length = summary.step_size > 0 ? summary.step_size : 1;
  if (!run_->Accept(*x_, gradient_, step_length, summary.cost)) return false;
  if (MaxNorm(gradient_) < best_) {
    KeepBest();
  } else if (std::abs(summary.cost_change) <= kRounding * std::abs(summary.cost) &&
             ++idle_ >= kMaxIdle) {
    Stall("the value changes by rounding only and the gradient no longer falls");
    return false;
  }
  return true;
}

void CeresWatch::KeepBest() {
  best_ = MaxNorm(gradient_);
  best_x_ = *x_;
  idle_ = 0;
}

void CeresWatch::Stall(const std::string& message) {
  *x_ = best_x_;
  run_->summary().final_gradient_max = best_;
  run_->End(Termination::kStalled, message);
}

void CeresWatch::BeginRound() {
  round_ends_ = false;
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
  if (round_ends_ || best_ < kClearlySmaller * round_start_) return true;
  Stall(message);
  return false;
}

}  // namespace cirque

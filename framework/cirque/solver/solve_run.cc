#include "cirque/solver/solve_run.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace cirque {
namespace {

constexpr double kProgress =
    0.9;                        ///< a gradient below this share of the least one so far is progress
constexpr double kDeep = 1e-7;  ///< only gradients below this share of the first may be rounding,
constexpr double kNear = 10;    ///< or this near to the tolerance: a start may be nearly the end
constexpr int kRelaxations = 3;
constexpr double kRelaxedShare = 0.1;  ///< of the largest entry, in each of them
constexpr int kPatience = 2;           ///< steps without progress; near the tolerance one

}  // namespace

void Kinks::TakeLeastSubgradient(const Eigen::VectorXd& x, Eigen::VectorXd* gradient) const {
  for (const Kink& kink : kinks_) {
    if (x[kink.parameter] != 0) continue;
    double& slope = (*gradient)[kink.parameter];
    const double above = slope + kink.jump;
    if (slope <= 0) slope = above < 0 ? above : 0;
  }
}

void Kinks::Hold(const Eigen::VectorXd& x, const Eigen::VectorXd& subgradient,
                 SparseMatrix* lower) const {
  std::vector<bool> held(x.size(), false);
  for (const auto& [k, jump] : kinks_) held[k] = x[k] == 0 && subgradient[k] == 0;
  for (int j = 0; j < lower->outerSize(); ++j) {
    for (SparseMatrix::InnerIterator entry(*lower, j); entry; ++entry) {
      if (entry.row() != j && (held[j] || held[entry.row()])) entry.valueRef() = 0;
    }
  }
}

void Kinks::StopAt(const Eigen::VectorXd& x, const Eigen::VectorXd& subgradient,
                   Eigen::VectorXd* trial) const {
  for (const auto& [k, jump] : kinks_) {
    const double side = x[k] != 0 ? x[k] : -subgradient[k];
    if ((*trial)[k] * side <= 0) (*trial)[k] = 0;
  }
}

SolveRun::SolveRun(std::string strategy, const SolverLimits& limits, const SolveControl& control,
                   const Energy& energy)
    : limits_(limits), control_(control), energy_(energy), kinks_(energy) {
  summary_.strategy = std::move(strategy);
}

bool SolveRun::Value(const double* x, double* value, Eigen::VectorXd* gradient) {
  const Timer timer;
  if (gradient) gradient->resize(energy_.NumParameters());
  const bool defined =
      space().All(energy_.Evaluate(x, value, gradient ? gradient->data() : nullptr) &&
                  std::isfinite(*value) && (!gradient || gradient->allFinite()));
  if (gradient && defined && !kinks_.empty()) {
    kinks_.TakeLeastSubgradient(Eigen::Map<const Eigen::VectorXd>(x, gradient->size()), gradient);
  }
  ++summary_.value_evaluations;
  if (gradient) ++summary_.gradient_evaluations;
  summary_.evaluation_seconds += timer.Seconds();
  return defined;
}

bool SolveRun::Gradient(const Eigen::VectorXd& x, Eigen::VectorXd* gradient) {
  const Timer timer;
  gradient->resize(x.size());
  const bool defined =
      space().All(energy_.Gradient(x.data(), gradient->data()) && gradient->allFinite());
  kinks_.TakeLeastSubgradient(x, gradient);
  ++summary_.gradient_evaluations;
  summary_.evaluation_seconds += timer.Seconds();
  return defined;
}

bool SolveRun::Hessian(const Eigen::VectorXd& x, SparseMatrix* lower) {
  Eigen::VectorXd subgradient;
  if (!kinks_.empty() && !Gradient(x, &subgradient)) return false;
  const Timer timer;
  const bool defined = energy_.Hessian(x.data(), lower);
  if (defined && !kinks_.empty()) kinks_.Hold(x, subgradient, lower);
  ++summary_.hessian_evaluations;
  summary_.evaluation_seconds += timer.Seconds();
  return defined;
}

void SolveRun::Relax(Eigen::VectorXd* x, Eigen::VectorXd* gradient) {
  const Timer timer;
  for (int i = 0; i < kRelaxations && kinks_.empty(); ++i) {
    const double before = space().LargestEntry(*gradient);
    if (before <= limits_.gradient_tolerance) break;
    relaxed_ = *x;
    relaxed_gradient_ = *gradient;
    if (!energy_.Relax(kRelaxedShare * before, relaxed_.data(), relaxed_gradient_.data())) break;
    if (!(space().LargestEntry(relaxed_gradient_) < before)) break;
    x->swap(relaxed_);
    gradient->swap(relaxed_gradient_);
  }
  summary_.evaluation_seconds += timer.Seconds();
}

bool SolveRun::Factorize(const SparseMatrix& lower, SparseCholesky* cholesky) {
  const Timer timer;
  const bool factored = cholesky->Factorize(lower);
  summary_.symbolic_analyses = cholesky->symbolic_analyses();
  summary_.factorizations = cholesky->factorizations();
  summary_.factorization_seconds += timer.Seconds();
  return factored;
}

Eigen::VectorXd SolveRun::Solve(const Eigen::VectorXd& right_side, SparseCholesky* cholesky) {
  const Timer timer;
  ++summary_.linear_solves;
  Eigen::VectorXd x = cholesky->Solve(right_side);
  summary_.solve_seconds += timer.Seconds();
  return x;
}

bool SolveRun::Begin(const Eigen::VectorXd& x, Eigen::VectorXd* gradient) {
  if (!space().All(x.allFinite()) || !Value(x.data(), &summary_.initial_value, gradient)) {
    End(Termination::kInvalidStart, "the start lies outside the energy's domain");
    return false;
  }
  summary_.initial_gradient_max = space().LargestEntry(*gradient);
  return true;
}

bool SolveRun::RequireSmooth() {
  if (kinks_.empty()) return true;
  End(Termination::kUnsupported,
      "the energy has kinks, which only newton and newton_cg treat; use one of them, or "
      "interior_point for an angle fit");
  return false;
}

bool SolveRun::StoppedAtRounding(const Eigen::VectorXd& gradient) {
  const double gradient_max = space().LargestEntry(gradient);
  if (gradient_max < kProgress * least_gradient_) {
    least_gradient_ = gradient_max;
    steps_since_least_ = 0;
    return false;
  }
  const bool near = least_gradient_ <= kNear * limits_.gradient_tolerance;
  if (++steps_since_least_ < (near ? 1 : kPatience)) return false;
  if (!near && least_gradient_ > kDeep * summary_.initial_gradient_max) return false;
  End(Termination::kStalled,
      fmt::format("gradient {:.2e} no longer falls: its terms are rounded there", gradient_max));
  return true;
}

bool SolveRun::Continue(const Eigen::VectorXd& gradient) {
  if (summary_.termination != Termination::kNotRun) return false;
  const double gradient_max = space().LargestEntry(gradient);
  summary_.final_gradient_max = gradient_max;
  if (gradient_max <= limits_.gradient_tolerance) {
    End(Termination::kConverged,
        fmt::format("gradient {:.2e} <= {:.2e}", gradient_max, limits_.gradient_tolerance));
  } else if (space().FirstSays(control_.cancelled && control_.cancelled->load())) {
    End(Termination::kCancelled, "cancelled by the caller");
  } else if (summary_.num_iterations() >= limits_.max_iterations) {
    End(Termination::kIterationLimit, fmt::format("{} iterations", limits_.max_iterations));
  } else if (space().FirstSays(timer_.Seconds() > limits_.max_seconds)) {
    End(Termination::kTimeLimit, fmt::format("{} s", limits_.max_seconds));
  }
  return summary_.termination == Termination::kNotRun;
}

bool SolveRun::CallerStops(const IterationRecord& record, const Eigen::VectorXd& x) const {
  if (!space().FirstSays(static_cast<bool>(control_.callback))) return false;
  Eigen::VectorXd room;
  const Eigen::VectorXd& whole = space().Whole(x, &room);
  return space().FirstSays(control_.callback &&
                           control_.callback(record, whole) == CallbackAction::kStop);
}

bool SolveRun::Accept(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient, double step_length,
                      double value) {
  IterationRecord record;
  record.value = value;
  record.iteration = summary_.num_iterations() + 1;
  record.gradient_max = space().LargestEntry(gradient);
  record.step_length = step_length;
  record.seconds = timer_.Seconds();
  summary_.iterations.push_back(record);
  summary_.x_changed = true;
  if (CallerStops(record, x)) {
    summary_.final_gradient_max = record.gradient_max;
    End(Termination::kStoppedByCaller, "the iteration callback asked to stop");
    return false;
  }
  return true;
}

void SolveRun::End(Termination termination, std::string message) {
  summary_.termination = termination;
  summary_.message = std::move(message);
}

SolveSummary SolveRun::Finish(const Eigen::VectorXd& x) {
  const bool began = summary_.termination != Termination::kInvalidStart &&
                     summary_.termination != Termination::kUnsupported;
  if (began) Value(x.data(), &summary_.final_value, nullptr);
  summary_.total_seconds = timer_.Seconds();
  return std::move(summary_);
}

}  // namespace cirque

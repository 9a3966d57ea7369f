#include "cirque/solver/newton_loop.h"

#include <algorithm>

#include "cirque/core/parallel.h"
#include "cirque/linear/sparse_matrix.h"

namespace cirque {

namespace {

constexpr double kRaise = 100, kLower = 0.01, kRaisedLeast = 1e-5, kMost = 1e8;
constexpr double kShortStep = 0.01, kFullStep = 0.99;
constexpr double kBelowTolerance = 1e-3;  ///< where a chord's step is to end

}  // namespace

LevenbergMarquardtDamping::LevenbergMarquardtDamping(const Energy& energy)
    : least_(energy.LeastDamping()), gauge_(energy.GaugeParameters()), damping_(least_) {}

void LevenbergMarquardtDamping::DampHessian(SparseMatrix* hessian) {
  diagonal_ = Diagonal(*hessian);
  scale_ = diagonal_.size() > 0 ? diagonal_.mean() : 1;
  Apply(hessian);
}

void LevenbergMarquardtDamping::Apply(SparseMatrix* hessian) const {
  ParallelFor(static_cast<int>(diagonal_.size()),
              [&](int j) { DiagonalEntry(hessian, j) = diagonal_[j] + damping_; });
  for (const int g : gauge_) DiagonalEntry(hessian, g) *= 2;
}

bool LevenbergMarquardtDamping::Raise(SparseMatrix* hessian) {
  if (!Raise()) return false;
  Apply(hessian);
  return true;
}

bool LevenbergMarquardtDamping::Raise() {
  if (damping_ >= kMost * scale_) return false;
  damping_ = std::max(damping_ * kRaise, kRaisedLeast * scale_);
  return true;
}

void LevenbergMarquardtDamping::Adapt(double step_length) {
  if (step_length < kShortStep) {
    Raise();
  } else if (step_length > kFullStep) {
    damping_ = std::max(least_, damping_ * kLower);
    if (least_ == 0 && damping_ < 1e-12 * scale_) damping_ = 0;
  }
}

ChordTest::ChordTest(const SolveRun& run)
    : space_(run.space()),
      goal_(run.kinks().empty() ? kBelowTolerance * run.gradient_tolerance() : 0) {}

bool ChordTest::LastHessianDoes(const Eigen::VectorXd& gradient) {
  const double now = space_.LargestEntry(gradient);
  const bool does = last_max_ > 0 && now * (now / last_max_) < goal_;
  last_max_ = now;
  return does;
}

namespace {

void Search(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient,
            const Eigen::VectorXd& direction, LineSearch search, SolveRun* run,
            LineSearchResult* step) {
  return run->kinks().empty() ? search(x, gradient, direction, run, step)
                              : SearchAlongKinks(run->kinks(), x, gradient, direction, run, step);
}

}  // namespace

void IterateNewton(const DirectionFinder& find_direction, SolveRun* run, Eigen::VectorXd* x,
                   LineSearch search) {
  LevenbergMarquardtDamping damping(run->energy());
  Eigen::VectorXd gradient, direction;
  LineSearchResult step;
  if (!run->Begin(*x, &gradient)) return;
  while (run->Continue(gradient)) {
    if (run->StoppedAtRounding(gradient)) return;
    if (!find_direction(*x, gradient, &damping, &direction)) {
      run->End(Termination::kStalled, "the Hessian could not be made positive definite");
      return;
    }
    Search(*x, gradient, direction, search, run, &step);
    if (!step.found) {
      if (damping.Raise()) continue;
      run->End(Termination::kStalled, "no step along the Newton direction improves x");
      return;
    }
    damping.Adapt(step.step_length);
    x->swap(step.x);
    gradient.swap(step.gradient);
    run->Relax(x, &gradient);
    if (!run->Accept(*x, gradient, step.step_length)) return;
  }
}

}  // namespace cirque

#include "cirque/solver/inexact_newton.h"

#include <algorithm>
#include <functional>

#include "cirque/solver/newton_loop.h"

namespace cirque {
namespace {

constexpr int kMaxAttempts = 12;
constexpr double kLeastForcing = 1e-4;
constexpr double kShareOfGoal = 0.3;  ///< what the last system may leave of the gradient tolerance

/// Solves each Newton system, with a shift where the matrix turns out not to be positive definite.
class InexactDirection {
 public:
  InexactDirection(double forcing, SystemSolver* solver, SolveRun* run)
      : forcing_(forcing), solver_(solver), run_(run) {}

  bool operator()(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient, HessianShift* shift,
                  Eigen::VectorXd* direction) {
    if (!run_->Hessian(x, &hessian_)) return false;
    shift->Regularize(&hessian_);
    const double goal = run_->gradient_tolerance() / gradient.lpNorm<Eigen::Infinity>();
    const SolveAccuracy accuracy = {Forcing(gradient.norm(), goal), goal};
    for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
      const bool solved =
          solver_->Solve(hessian_, -gradient, accuracy, direction, &run_->summary());
      if (solved && direction->dot(gradient) < 0) return true;
      if (!shift->Raise(&hessian_)) return false;
    }
    return false;
  }

 private:
  /// How tightly to solve at this gradient norm, from which the whole solve is to go down by
  /// `goal`.
  double Forcing(double norm, double goal) {
    const double ratio = norm / last_norm_;
    last_norm_ = norm;
    return std::min(forcing_, std::max({ratio * ratio, kShareOfGoal * goal, kLeastForcing}));
  }

  const double forcing_;
  SystemSolver* solver_;
  SolveRun* run_;
  SparseMatrix hessian_;
  double last_norm_ = 0;  ///< 0: none, the first system is solved loosely
};

}  // namespace

void IterateInexactNewton(double forcing, SystemSolver* solver, SolveRun* run, Eigen::VectorXd* x) {
  InexactDirection direction(forcing, solver, run);
  IterateNewton(std::ref(direction), run, x);
}

}  // namespace cirque

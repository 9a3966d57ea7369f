#include "cirque/solver/inexact_newton.h"

#include <algorithm>
#include <functional>

namespace cirque {
namespace {

constexpr int kMaxAttempts = 12;
constexpr double kLeastForcing = 1e-4;
constexpr double kShareOfGoal = 0.3;  ///< what the last system may leave of the gradient tolerance

/// Those of an energy that is whole.
class WholeSystems final : public NewtonSystems {
 public:
  WholeSystems(SystemSolver* solver, SolveRun* run) : solver_(*solver), run_(*run) {}

  bool Linearize(const Eigen::VectorXd& x, LevenbergMarquardtDamping* damping) override {
    if (!run_.Hessian(x, &hessian_)) return false;
    damping->DampHessian(&hessian_);
    return true;
  }
  bool Raise(LevenbergMarquardtDamping* damping) override { return damping->Raise(&hessian_); }
  bool Solve(const Eigen::VectorXd& right_side, const SolveAccuracy& accuracy,
             Eigen::VectorXd* direction) override {
    return solver_.Solve(hessian_, right_side, accuracy, direction, &run_.summary());
  }

 private:
  SystemSolver& solver_;
  SolveRun& run_;
  SparseMatrix hessian_;
};

/// Solves each Newton system, with a damping where the matrix turns out not to be positive definite.
class InexactDirection {
 public:
  InexactDirection(double forcing, NewtonSystems* systems, const SolveRun& run)
      : forcing_(forcing),
        systems_(*systems),
        space_(run.space()),
        gradient_tolerance_(run.gradient_tolerance()),
        chord_(run) {}

  bool operator()(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient,
                  LevenbergMarquardtDamping* damping, Eigen::VectorXd* direction) {
    if (!chord_.LastHessianDoes(gradient) && !systems_.Linearize(x, damping)) return false;
    const double goal = gradient_tolerance_ / space_.LargestEntry(gradient);
    const SolveAccuracy accuracy = {Forcing(space_.Norm(gradient), goal), goal};
    for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
      const bool solved = systems_.Solve(-gradient, accuracy, direction);
      if (solved && space_.Dot(*direction, gradient) < 0) return true;
      if (!systems_.Raise(damping)) return false;
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
  NewtonSystems& systems_;
  const ParameterSpace& space_;
  const double gradient_tolerance_;
  ChordTest chord_;
  double last_norm_ = 0;  ///< 0: none, the first system is solved loosely
};

}  // namespace

void IterateInexactNewton(double forcing, NewtonSystems* systems, SolveRun* run,
                          Eigen::VectorXd* x) {
  InexactDirection direction(forcing, systems, *run);
  IterateNewton(std::ref(direction), run, x);
}

void IterateInexactNewton(double forcing, SystemSolver* solver, SolveRun* run, Eigen::VectorXd* x) {
  WholeSystems systems(solver, run);
  IterateInexactNewton(forcing, &systems, run, x);
}

}  // namespace cirque

#include <algorithm>
#include <functional>
#include <utility>

#include "cirque/linear/lagged_factorization.h"
#include "cirque/linear/registry.h"
#include "cirque/solver/newton_loop.h"
#include "cirque/solver/newton_strategies.h"

namespace cirque {
namespace {

constexpr int kMaxAttempts = 12;
constexpr double kLeastForcing = 1e-4;
constexpr double kShareOfGoal = 0.3;  ///< what the last system may leave of the gradient tolerance

/// Solves each Newton system, with a damping where the matrix turns out not to be positive definite.
class InexactDirection {
 public:
  InexactDirection(double forcing, SystemSolver* solver, SolveRun* run)
      : forcing_(forcing), solver_(solver), run_(run) {}

  bool operator()(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient,
                  LevenbergMarquardtDamping* damping, Eigen::VectorXd* direction) {
    if (!run_->Hessian(x, &hessian_)) return false;
    damping->DampHessian(&hessian_);
    const double goal = run_->gradient_tolerance() / gradient.lpNorm<Eigen::Infinity>();
    const SolveAccuracy accuracy = {Forcing(gradient.norm(), goal), goal};
    for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
      const bool solved =
          solver_->Solve(hessian_, -gradient, accuracy, direction, &run_->summary());
      if (solved && direction->dot(gradient) < 0) return true;
      if (!damping->Raise(&hessian_)) return false;
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

/// A strategy's table: the limits, the option of its own, and those of all inexact Newton methods.
template <class O>
OptionTable<O> TableOf(const std::string& strategy, const Option<O>& own,
                       const std::string& cg_limit_help) {
  auto options = Joined<O>(LimitOptions<O>(), {own});
  return OptionTable<O>(
      strategy,
      Joined<O>(
          std::move(options),
          {Option<O>("max_cg_iterations", &O::max_cg_iterations, cg_limit_help).Between(1, 1e6),
           Option<O>("forcing", &O::forcing, "relative residual of the first steps' linear systems")
               .Between(1e-10, 0.9)}));
}

}  // namespace

void IterateInexactNewton(double forcing, SystemSolver* solver, SolveRun* run, Eigen::VectorXd* x) {
  InexactDirection direction(forcing, solver, run);
  IterateNewton(std::ref(direction), run, x);
}

const OptionTable<NewtonCgOptions>& NewtonCgOptionTable() {
  using O = NewtonCgOptions;
  static const auto kTable = TableOf<O>(
      "newton_cg",
      Option<O>("linear_solver", &O::linear_solver, "sparse Cholesky; default: the first")
          .OneOf(LinearSolvers().Names()),
      "conjugate gradient iterations a step before factoring anew");
  return kTable;
}

SolveSummary NewtonCgStrategy::Minimize(const Energy& energy, const SolveControl& control,
                                        Eigen::VectorXd* x) const {
  SolveRun run("newton_cg", options_, control, energy);
  LaggedFactorization own(MakeCholesky(options_.linear_solver), options_.max_cg_iterations);
  SystemSolver* solver = control.system_solver ? control.system_solver : &own;
  IterateInexactNewton(options_.forcing, solver, &run, x);
  return run.Finish(*x);
}

const OptionTable<NewtonAmgOptions>& NewtonAmgOptionTable() {
  using O = NewtonAmgOptions;
  static const auto kTable = TableOf<O>(
      "newton_amg",
      Option<O>("multigrid", &O::multigrid, "the method; default: boomeramg where PETSc has hypre")
          .OneOf({"boomeramg", "gamg"}),
      "conjugate gradient iterations a system before factoring it");
  return kTable;
}

SolveSummary NewtonAmgStrategy::Minimize(const Energy& energy, const SolveControl& control,
                                         Eigen::VectorXd* x) const {
  SolveRun run("newton_amg", options_, control, energy);
  AmgSystemSolver own(options_);
  SystemSolver* solver = control.system_solver ? control.system_solver : &own;
  if (SparseMatrix smooth; !control.system_solver && energy.SmoothHessian(x->data(), &smooth)) {
    LevenbergMarquardtDamping(energy).DampHessian(&smooth);
    own.PrepareForSystemsNear(smooth, &run.summary());
  }
  IterateInexactNewton(options_.forcing, solver, &run, x);
  SolveSummary summary = run.Finish(*x);
  if (const std::string remark = solver->Remark(); !remark.empty()) {
    summary.message += "; " + remark;
    summary.strategy += ", " + remark;
  }
  return summary;
}

std::unique_ptr<SystemSolver> NewtonAmgStrategy::MakeSystemSolver(int) const {
  return std::make_unique<AmgSystemSolver>(options_);
}

}  // namespace cirque

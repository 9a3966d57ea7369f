#include <algorithm>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "cirque/linear/lagged_factorization.h"
#include "cirque/linear/registry.h"
#include "cirque/solver/newton_loop.h"
#include "cirque/solver/newton_strategies.h"

namespace cirque {
namespace {

constexpr int kMaxAttempts = 12;
constexpr double kLeastForcing = 1e-4;
constexpr double kShareOfGoal = 0.3;  ///< what the last system may leave of the gradient tolerance

/// Newton's systems, one after another.
class NewtonSystems {
 public:
  virtual ~NewtonSystems() = default;

  /// Turns to the Hessian at x, damped.
  virtual bool Linearize(const Eigen::VectorXd& x, LevenbergMarquardtDamping* damping) = 0;

  /// Damps it more.
  virtual bool Raise(LevenbergMarquardtDamping* damping) = 0;
  virtual bool Solve(const Eigen::VectorXd& right_side, const SolveAccuracy& accuracy,
                     Eigen::VectorXd* direction) = 0;
};

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

/// Those of an energy whose parts the ranks have.
class SystemsOnRanks final : public NewtonSystems {
 public:
  SystemsOnRanks(const EnergyOnRanks& energy, SolveRun* run) : energy_(energy), run_(*run) {}

  /// One hierarchy for all, that of the smooth Hessian, where there is one.
  void Prepare(const Eigen::VectorXd& x) {
    LevenbergMarquardtDamping damping(energy_);
    double mean_diagonal = 0;
    if (!energy_.LinearizeSmooth(x.data(), &mean_diagonal)) return;
    energy_.PrepareForSystemsNear(damping.damping(), &run_.summary());
  }

  bool Linearize(const Eigen::VectorXd& x, LevenbergMarquardtDamping* damping) override {
    const Timer timer;
    double mean_diagonal = 0;
    const bool defined = energy_.Linearize(x.data(), &mean_diagonal);
    damping->SetScale(mean_diagonal);
    damping_ = damping->damping();
    ++run_.summary().hessian_evaluations;
    run_.summary().evaluation_seconds += timer.Seconds();
    return defined;
  }
  bool Raise(LevenbergMarquardtDamping* damping) override {
    // Where multigrid does not converge others do it, with the energy as a whole.
    const bool raised = !energy_.failed() && damping->Raise();
    damping_ = damping->damping();
    return raised;
  }
  bool Solve(const Eigen::VectorXd& right_side, const SolveAccuracy& accuracy,
             Eigen::VectorXd* direction) override {
    return energy_.Solve(damping_, right_side, accuracy.tolerance, direction, &run_.summary());
  }

 private:
  const EnergyOnRanks& energy_;
  SolveRun& run_;
  double damping_ = 0;
};

/// Solves each Newton system, with a damping where the matrix turns out not to be positive definite.
class InexactDirection {
 public:
  InexactDirection(double forcing, NewtonSystems* systems, const SolveRun& run)
      : forcing_(forcing),
        systems_(*systems),
        gradient_tolerance_(run.gradient_tolerance()),
        chord_(run) {}

  bool operator()(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient,
                  LevenbergMarquardtDamping* damping, Eigen::VectorXd* direction) {
    if (!chord_.LastHessianDoes(gradient) && !systems_.Linearize(x, damping)) return false;
    const double goal = gradient_tolerance_ / gradient.lpNorm<Eigen::Infinity>();
    const SolveAccuracy accuracy = {Forcing(gradient.norm(), goal), goal};
    for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
      const bool solved = systems_.Solve(-gradient, accuracy, direction);
      if (solved && direction->dot(gradient) < 0) return true;
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
  const double gradient_tolerance_;
  ChordTest chord_;
  double last_norm_ = 0;  ///< 0: none, the first system is solved loosely
};

void Iterate(double forcing, NewtonSystems* systems, SolveRun* run, Eigen::VectorXd* x) {
  InexactDirection direction(forcing, systems, *run);
  IterateNewton(std::ref(direction), run, x);
}

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
  WholeSystems systems(solver, run);
  Iterate(forcing, &systems, run, x);
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
  if (const auto* on_ranks = dynamic_cast<const EnergyOnRanks*>(&energy)) {
    return MinimizeOnRanks(*on_ranks, control, x);
  }
  const EnergySource* source = control.system_solver ? nullptr : energy.source();
  if (const auto on_ranks = source ? TakeToRanks(*source) : nullptr) {
    SolveSummary summary = MinimizeOnRanks(*on_ranks, control, x);
    if (!on_ranks->failed()) return summary;
  }
  return MinimizeWhole(energy, control, x);
}

SolveSummary NewtonAmgStrategy::MinimizeOnRanks(const EnergyOnRanks& energy,
                                                const SolveControl& control,
                                                Eigen::VectorXd* x) const {
  SolveRun run(fmt::format("newton_amg on {} ranks", energy.num_ranks()), options_, control,
               energy);
  SystemsOnRanks systems(energy, &run);
  systems.Prepare(*x);
  Iterate(options_.forcing, &systems, &run, x);
  return run.Finish(*x);
}

SolveSummary NewtonAmgStrategy::MinimizeWhole(const Energy& energy, const SolveControl& control,
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

std::unique_ptr<EnergyOnRanks> NewtonAmgStrategy::TakeToRanks(const EnergySource& source) const {
  return EnergyOnRanks::Make(source, options_);
}

}  // namespace cirque

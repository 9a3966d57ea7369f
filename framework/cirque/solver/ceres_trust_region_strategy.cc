#include <limits>
#include <memory>

#include <ceres/evaluation_callback.h>
#include <ceres/solver.h>

#include "cirque/solver/ceres_adapter.h"
#include "cirque/solver/ceres_strategies.h"
#include "cirque/solver/gradient_residuals.h"

namespace cirque {
namespace {

constexpr int kMaxIdle = 3;
constexpr double kMostThreads = 256, kLeastRadius = 1e-6, kMostRadius = 1e15;

ceres::SparseLinearAlgebraLibraryType SparseLibrary() {
  return ceres::IsSparseLinearAlgebraLibraryTypeAvailable(ceres::SUITE_SPARSE)
             ? ceres::SUITE_SPARSE
             : ceres::EIGEN_SPARSE;
}

ceres::Solver::Options SolverOptions(const CeresTrustRegionOptions& options) {
  ceres::Solver::Options result;
  result.minimizer_type = ceres::TRUST_REGION;
  result.trust_region_strategy_type = options.trust_region;
  result.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  result.sparse_linear_algebra_library_type = SparseLibrary();
  result.initial_trust_region_radius = options.initial_radius;
  result.use_nonmonotonic_steps = true;
  result.num_threads = options.num_threads;
  result.max_num_iterations = std::numeric_limits<int>::max() - 1;
  result.max_solver_time_in_seconds = options.max_seconds;
  result.function_tolerance = result.gradient_tolerance = result.parameter_tolerance = 0;
  result.logging_type = ceres::SILENT;
  return result;
}

/// One minimisation: Ceres' problem, solved in rounds, and what it evaluates.
class TrustRegionSolve final : public ceres::EvaluationCallback {
 public:
  TrustRegionSolve(const CeresTrustRegionOptions& options, const Eigen::VectorXd& gradient,
                   SolveRun* run, Eigen::VectorXd* x)
      : options_(SolverOptions(options)),
        run_(run),
        x_(x),
        state_(*x),
        accepted_(*x),
        watch_(
            run,
            [run](const Eigen::VectorXd& p, Eigen::VectorXd* g) { return run->Gradient(p, g); },
            [this] { return accepted_; }, gradient, kMaxIdle, x) {
    if (options.residuals == TrustRegionResiduals::kGradient) {
      gradient_form_ = std::make_unique<GradientResiduals>(run->energy(), run);
    }
    options_.callbacks.push_back(&watch_);
  }

  void Execute() {
    std::string message;
    do {
      message = Round();
    } while (watch_.AnotherRoundHelps(message));
  }

  void PrepareForEvaluation(bool evaluate_jacobians, bool new_point) override {
    if (evaluate_jacobians) accepted_ = state_;
    if (!gradient_form_ || !(new_point || evaluate_jacobians)) return;
    if (!gradient_form_->Update(state_, evaluate_jacobians)) watch_.EndRound();
  }

 private:
  /// Solves from *x_ and returns why Ceres stopped.
  std::string Round() {
    state_ = *x_;
    ceres::Problem::Options ownership;
    ownership.evaluation_callback = this;
    ceres::Problem problem(ownership);
    if (gradient_form_) {
      gradient_form_->Update(state_, true);
      gradient_form_->AddTo(state_.data(), &problem);
    } else {
      run_->energy().AddResidualBlocks(state_.data(), &problem);
    }
    watch_.BeginRound();
    ceres::Solver::Summary summary;
    ceres::Solve(options_, &problem, &summary);
    Tally(summary);
    watch_.Offer(state_);
    return summary.message;
  }

  void Tally(const ceres::Solver::Summary& ceres_summary) {
    SolveSummary& summary = run_->summary();
    ++summary.symbolic_analyses;
    summary.factorizations += ceres_summary.num_linear_solves;
    summary.linear_solves += ceres_summary.num_linear_solves;
    summary.factorization_seconds += ceres_summary.linear_solver_time_in_seconds;
    // Gradient residuals count and time themselves.
    if (gradient_form_) return;
    summary.value_evaluations += ceres_summary.num_residual_evaluations;
    summary.hessian_evaluations += ceres_summary.num_jacobian_evaluations;
    summary.evaluation_seconds += ceres_summary.residual_evaluation_time_in_seconds +
                                  ceres_summary.jacobian_evaluation_time_in_seconds;
  }

  ceres::Solver::Options options_;
  SolveRun* run_;
  Eigen::VectorXd* x_;
  Eigen::VectorXd state_;     ///< Ceres' parameter blocks: the point that it evaluates
  Eigen::VectorXd accepted_;  ///< where it evaluated Jacobians last: its last accepted point
  CeresWatch watch_;
  std::unique_ptr<GradientResiduals> gradient_form_;  ///< null: the energy's own residuals
};

}  // namespace

bool OffersResiduals(const Energy& energy) {
  return energy.residual_form() != ResidualForm::kAbsent;
}

const OptionTable<CeresTrustRegionOptions>& CeresTrustRegionOptionTable() {
  using O = CeresTrustRegionOptions;
  static const OptionTable<O> kTable(
      "ceres_trust_region",
      Joined<O>(LimitOptions<O>(),
                {{"trust_region", &O::trust_region, "method"},
                 {"residuals", &O::residuals, "the energy's own, or its gradient as residuals"},
                 Option<O>("initial_radius", &O::initial_radius, "of the trust region")
                     .Between(kLeastRadius, kMostRadius),
                 Option<O>("num_threads", &O::num_threads, "for residuals and Jacobians")
                     .Between(1, kMostThreads)}));
  return kTable;
}

SolveSummary CeresTrustRegionStrategy::Minimize(const Energy& energy, const SolveControl& control,
                                                Eigen::VectorXd* x) const {
  SolveRun run("ceres_trust_region", options_, control, energy);
  if (options_.residuals == TrustRegionResiduals::kExact && !OffersResiduals(energy)) {
    run.End(Termination::kUnsupported,
            "the energy has no least-squares form; use residuals = gradient or another strategy");
    return run.Finish(*x);
  }
  Eigen::VectorXd gradient;
  if (run.RequireSmooth() && run.Begin(*x, &gradient) && run.Continue(gradient)) {
    TrustRegionSolve(options_, gradient, &run, x).Execute();
  }
  return run.Finish(*x);
}

}  // namespace cirque

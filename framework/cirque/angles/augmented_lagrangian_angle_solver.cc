#include "cirque/angles/augmented_lagrangian_angle_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <ceres/iteration_callback.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <fmt/format.h>

#include "cirque/angles/infeasibility.h"
#include "cirque/core/solve_summary.h"

namespace cirque {
namespace {

constexpr double kSufficientFall = 0.25;
constexpr double kRoom = 0.05;               ///< [rad]: what the start leaves to every inequality
constexpr double kGaussNewtonRadius = 1e16;  ///< a trust region that does not damp

class AugmentedLagrangianSolve final : public ceres::IterationCallback {
 public:
  AugmentedLagrangianSolve(const AngleFitProblem& problem, const AngleObjective& objective,
                           const AugmentedLagrangianOptions& options, const SolveControl& control)
      : fit_(problem),
        t_(problem.constraints.triangulation()),
        objective_(objective),
        options_(options),
        control_(control),
        margin_(objective.Margin(problem.epsilon)),
        watch_(problem.constraints, margin_) {
    summary_.strategy = "ceres_augmented_lagrangian";
  }

  SolveSummary Run() {
    Start();
    AddAngleResiduals(fit_, objective_, state_, alpha_.data(), &problem_);
    for (int outer = 0; summary_.termination == Termination::kNotRun; ++outer) {
      if (outer == options_.max_outer_iterations) {
        End(Termination::kIterationLimit, fmt::format("{} multiplier updates", outer));
        break;
      }
      if (!MinimizeInner()) break;
      UpdateMultipliers();
    }
    summary_.final_gradient_max = residual_;
    summary_.total_seconds = timer_.Seconds();
    return std::move(summary_);
  }

  const Eigen::VectorXd& angles() const { return alpha_; }
  const Eigen::VectorXd& multipliers() const { return state_.y; }
  const InfeasibilityCertificate& certificate() const { return watch_.certificate(); }

  /// Ceres's callback: records accepted steps and knows when to end.
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& step) override {
    if (step.iteration > 0 && step.step_is_successful) Record(step);
    if (control_.cancelled && control_.cancelled->load()) {
      End(Termination::kCancelled, "cancelled by the caller");
    } else if (summary_.num_iterations() >= options_.max_iterations) {
      End(Termination::kIterationLimit, fmt::format("{} iterations", options_.max_iterations));
    } else if (timer_.Seconds() > options_.max_seconds) {
      End(Termination::kTimeLimit, fmt::format("{} s", options_.max_seconds));
    }
    return summary_.termination == Termination::kNotRun ? ceres::SOLVER_CONTINUE
                                                        : ceres::SOLVER_TERMINATE_SUCCESSFULLY;
  }

 private:
  void Start() {
    alpha_.resize(t_.num_halfedges());
    double curvature = 0;
    for (Index h = 0; h < t_.num_halfedges(); ++h) {
      const double reference = objective_.ClampReference(fit_.reference[h], fit_.epsilon);
      // Low enough that the two angles opposite an edge leave room to their intersection angle.
      alpha_[h] = std::clamp(reference, kRoom, 0.5 * (kPi - kRoom));
      curvature += objective_.Distance(reference, alpha_[h]).curvature;
    }
    scale_ = curvature / static_cast<double>(t_.num_halfedges());
    state_.penalty = options_.first_penalty * scale_;
    state_.y = Eigen::VectorXd::Zero(fit_.constraints.num_rows());
    state_.of_lower = Eigen::VectorXd::Zero(t_.num_halfedges());
    state_.of_sums = Eigen::VectorXd::Zero(t_.num_edges());
    const KktReport start = CheckFeasibility(fit_.constraints, alpha_);
    summary_.initial_gradient_max =
        std::max(start.triangle_sum_residual, start.vertex_sum_residual);
    residual_ = std::numeric_limits<double>::infinity();
  }

  ceres::Solver::Options InnerOptions() {
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
    options.initial_trust_region_radius = options.max_trust_region_radius = kGaussNewtonRadius;
    options.max_num_consecutive_invalid_steps = 100;
    options.max_num_iterations = std::max(1, options_.max_iterations - summary_.num_iterations());
    options.function_tolerance = options.parameter_tolerance = 1e-14;
    options.gradient_tolerance = 1e-13 * scale_;
    options.logging_type = ceres::SILENT;
    options.update_state_every_iteration = true;
    options.callbacks = {this};
    return options;
  }

  /// False when Ceres could not go on.
  bool MinimizeInner() {
    ceres::Solver::Summary inner;
    ceres::Solve(InnerOptions(), &problem_, &inner);
    summary_.value_evaluations += inner.num_residual_evaluations;
    summary_.gradient_evaluations += inner.num_jacobian_evaluations;
    summary_.evaluation_seconds +=
        inner.residual_evaluation_time_in_seconds + inner.jacobian_evaluation_time_in_seconds;
    summary_.factorizations += inner.num_linear_solves;
    summary_.linear_solves += inner.num_linear_solves;
    summary_.factorization_seconds += inner.linear_solver_time_in_seconds;
    if (summary_.termination == Termination::kNotRun && inner.termination_type == ceres::FAILURE) {
      End(Termination::kStalled, inner.message);
    }
    return summary_.termination == Termination::kNotRun;
  }

  /// First order: what the penalties' gradients are at the inner minimum.
  void UpdateMultipliers() {
    const AngleConstraints& constraints = fit_.constraints;
    const Eigen::VectorXd sums = constraints.Apply(alpha_);
    double residual = 0;
    for (int row = 0; row < constraints.num_rows(); ++row) {
      const double lower = constraints.Lower(row), upper = constraints.Upper(row);
      residual = std::max(residual, std::abs(SignedDistance(sums[row], lower, upper)));
      state_.y[row] = -state_.penalty *
                      SignedDistance(sums[row] - state_.y[row] / state_.penalty, lower, upper);
    }
    const auto update = [&](double excess, double* multiplier) {
      residual = std::max(residual, std::max(excess, -*multiplier / state_.penalty));
      *multiplier = std::max(0.0, *multiplier + state_.penalty * excess);
    };
    for (Index e = 0; e < t_.num_edges() && margin_ > 0; ++e) {
      const Index l = t_.edge_halfedge[e], r = t_.twin[l];
      const EdgeMargins margins = MarginsOf(fit_, objective_, l);
      update(margins.l - alpha_[l], &state_.of_lower[l]);
      if (r != kNone) update(margins.r - alpha_[r], &state_.of_lower[r]);
      const double opposite = r == kNone ? 0 : alpha_[r];
      update(alpha_[l] + opposite - (kPi - margins.theta), &state_.of_sums[e]);
    }
    Judge(residual);
  }

  void Judge(double residual) {
    if (watch_.Found(state_.y)) return End(Termination::kStoppedByCaller, "infeasible");
    if (residual <= options_.sum_tolerance) {
      End(Termination::kConverged, fmt::format("sums miss by {:.1e} rad", residual));
    } else if (residual > kSufficientFall * residual_) {
      const double largest = options_.largest_penalty * scale_;
      if (state_.penalty >= largest && residual >= residual_ && residual < 1e-9) {
        End(Termination::kStalled, fmt::format("sums miss by {:.1e} rad", residual));
      }
      state_.penalty = std::min(largest, options_.penalty_growth * state_.penalty);
    }
    residual_ = residual;
  }

  void Record(const ceres::IterationSummary& step) {
    IterationRecord record;
    record.iteration = summary_.num_iterations() + 1;
    record.value = step.cost;
    record.gradient_max = step.gradient_max_norm;
    record.step_length = step.step_size;
    record.seconds = timer_.Seconds();
    summary_.iterations.push_back(record);
    summary_.x_changed = true;
    if (control_.callback && control_.callback(record, alpha_) == CallbackAction::kStop) {
      End(Termination::kStoppedByCaller, "the iteration callback asked to stop");
    }
  }

  void End(Termination termination, std::string message) {
    if (summary_.termination != Termination::kNotRun) return;
    summary_.termination = termination;
    summary_.message = std::move(message);
  }

  const AngleFitProblem& fit_;
  const Triangulation& t_;
  const AngleObjective& objective_;
  const AugmentedLagrangianOptions& options_;
  const SolveControl& control_;
  const double margin_;
  InfeasibilityWatch watch_;
  Timer timer_;
  SolveSummary summary_;
  Eigen::VectorXd alpha_;
  AugmentedState state_;
  ceres::Problem problem_;
  double scale_ = 1;
  double residual_ = 0;  ///< largest violation after the last inner solve [rad]
};

}  // namespace

const OptionTable<AugmentedLagrangianOptions>& AugmentedLagrangianOptionTable() {
  using O = AugmentedLagrangianOptions;
  constexpr double kMany = std::numeric_limits<int>::max();
  static const OptionTable<O> kTable(
      "ceres_augmented_lagrangian",
      {Option<O>("max_iterations", &O::max_iterations, "accepted inner steps in all")
           .Between(0, kMany),
       Option<O>("max_outer_iterations", &O::max_outer_iterations, "multiplier updates")
           .Between(1, kMany),
       Option<O>("first_penalty", &O::first_penalty, "relative to the mean curvature")
           .Between(1e-6, 1e12),
       Option<O>("penalty_growth", &O::penalty_growth, "where the residual fell too little")
           .Between(1, 1e6),
       Option<O>("largest_penalty", &O::largest_penalty, "relative to the mean curvature")
           .Between(1e-6, 1e12),
       Option<O>("sum_tolerance", &O::sum_tolerance, "largest residual of sums at the end")
           .Between(0, 1)
           .Unit("rad"),
       Option<O>("max_seconds", &O::max_seconds, "wall time").Between(0, 1e9).Unit("s")});
  return kTable;
}

Status AugmentedLagrangianAngleSolver::Fit(const AngleFitProblem& problem,
                                           const std::shared_ptr<const AngleObjective>& objective,
                                           const SolveControl& control,
                                           AngleFitResult* result) const {
  AugmentedLagrangianSolve solve(problem, *objective, options_, control);
  result->solve = solve.Run();
  const Status status = FinishFit(problem, *objective, solve.certificate(), solve.angles(),
                                  solve.multipliers(), result);
  result->solve.final_value = result->kkt.primal;
  return status;
}

}  // namespace cirque

#include "cirque/pipeline/solve_flat_metric.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cirque/angles/angle_fit.h"
#include "cirque/angles/registry.h"
#include "cirque/core/solve_summary.h"
#include "cirque/pipeline/close_rotations.h"
#include "cirque/pipeline/flat_metric.h"
#include "cirque/radii/solve_log_radii.h"

namespace cirque {
namespace {

constexpr char kRetry[] = "interior_point", kRetryObjective[] = "quadratic";
/// Share of the iterations after which a fit wanders: those that come to an end take under twenty.
constexpr double kPatience = 0.3;
/// The same where a map is wanted only if it is easy: those took 5 to 8 of them.
constexpr double kLittlePatience = 0.15;
/// Of the interior point a step costs less than one of the dual up to so many faces, and many times
/// as much at 50,000.
constexpr int kFewFaces = 20000;
/// A fit that has come no further after so many steps, most of them short, wanders as well: its line
/// search cuts steps that the dual's exponentials make too long, and of those that come to an end
/// (295 on 204 meshes) two had as many.
constexpr int kStepsToTell = 10, kShortStepsToTell = 8;
constexpr double kShortStep = 0.5;
/// One whose vertex sums have all this time missed by more than kFar wanders too: those that come
/// to an end are within a tenth of it by then.
constexpr int kStepsToComeNear = 15;
constexpr double kFar = 1;  // [rad]
/// Errors of the vertex sums add up over the layout: of a million faces, sums that miss by 5e-12 rad
/// leave edges that miss by 3e-8 of their length. From so many faces on less is allowed, down to
/// what rounding leaves.
constexpr double kManyFaces = 250000, kLeastTolerance = 2e-14;
constexpr char kFlat[] = "none: the surface is flat";

/// max |gradient| at the start and after every iteration.
std::vector<double> GradientsOf(const SolveSummary& solve) {
  std::vector<double> gradients = {solve.initial_gradient_max};
  for (const IterationRecord& step : solve.iterations) gradients.push_back(step.gradient_max);
  return gradients;
}

/// Tells a fit that wanders by its steps.
class WanderingWatch {
 public:
  explicit WanderingWatch(bool soon) : soon_(soon) {}

  bool Wanders(const IterationRecord& step) {
    nearest_ = step.iteration == 1 ? step.gradient_max : std::min(nearest_, step.gradient_max);
    if (step.iteration <= kStepsToTell && step.step_length < kShortStep) ++short_steps_;
    const bool far = step.iteration >= kStepsToComeNear && nearest_ > kFar;
    return far || (soon_ && step.iteration == kStepsToTell && short_steps_ >= kShortStepsToTell);
  }

 private:
  const bool soon_;  ///< where another way costs little
  double nearest_ = 0;
  int short_steps_ = 0;
};

/// One triangulation on its way to a flat metric.
class FlatMetricSolve {
 public:
  FlatMetricSolve(const FlattenJob& job, FitStart start, Certificate* certificate,
                  FlatSurface* result)
      : job_(job),
        options_(job.options),
        start_(start),
        certificate_(*certificate),
        result_(*result) {}

  Status Run() {
    result_.infeasibility = {};
    result_.is_own = false;
    const auto strategy = MakeSolverStrategy(options_.radii_solver, SolverOptions());
    return strategy.ok() ? FitAnglesAndRadii(**strategy) : strategy.status();
  }

 private:
  /// The radii's system is analysed while the angles are fitted, and left with this scope: the
  /// analysis reads a triangulation that the next round replaces.
  Status FitAnglesAndRadii(const SolverStrategy& strategy) {
    std::optional<IntrinsicSurface> flipped;
    if (!result_.intrinsic.flips.empty()) {
      flipped.emplace(MeasureSurface(t(), result_.intrinsic.lengths));
    }
    const IntrinsicSurface& solved = flipped ? *flipped : job_.surface;
    const ConeTargets targets = TransferTargets(job_.surface, job_.targets, solved);
    if (!MeetsRotations(job_)) {
      if (const auto flat = FlatMetricOf(solved, targets)) return TakeAsItIs(*flat, targets);
    }
    RadiiSystem system(t(), strategy);
    const auto fit = [&] { return FitAngles(solved, targets); };
    if (Status s = Timed(fit, &StageSeconds::angles); !s.ok()) return s;
    Status status = Timed([&] { return SolveRadii(strategy, &system); }, &StageSeconds::radii);
    const bool is_free = options_.holonomy == HolonomyRule::kFree && !MeetsRotations(job_);
    if (!status.ok() || is_free) return status;
    const auto close = [&] {
      const AngleConstraints constraints(t(), targets);
      return CloseRotations(job_, {constraints, solved.angles.value, options_.epsilon},
                            &certificate_, &result_);
    };
    return Timed(close, &StageSeconds::rotations);
  }

  template <class Step>
  Status Timed(const Step& step, std::optional<double> StageSeconds::*stage) {
    const Timer timer;
    Status status = step();
    AddSeconds(timer, &(certificate_.seconds.*stage));
    return status;
  }

  OptionMap SolverOptions() const {
    return {{"max_iterations", std::to_string(options_.max_iterations)}};
  }

  /// Another triangulation or method takes over from a fit that wanders.
  int MostSteps() const {
    const double patience = job_.dual == DualFit::kOrNothing ? kLittlePatience : kPatience;
    return std::max(1, static_cast<int>(patience * options_.max_iterations));
  }

  OptionMap AngleSolverOptions() const {
    if (options_.angle_solver != ParameterizeOptions().angle_solver) return SolverOptions();
    const double share = std::min(1., kManyFaces / t().num_faces());
    const double tolerance =
        std::max(kLeastTolerance, SolverLimits().gradient_tolerance * share * share);
    return {{"max_iterations", std::to_string(MostSteps())},
            {"gradient_tolerance", fmt::format("{}", tolerance)}};
  }

  const Triangulation& t() const { return result_.intrinsic.triangulation; }

  /// A flat surface needs no solve.
  Status TakeAsItIs(const FlatMetric& flat, const ConeTargets& targets) {
    const AngleConstraints constraints(t(), targets);
    result_.is_own = true;
    result_.angles = flat.angles;
    result_.log_radii = flat.log_radii;
    result_.multipliers = Eigen::VectorXd::Zero(constraints.num_rows());
    AngleFitResult fit;
    fit.angles = flat.angles;
    fit.kkt = CheckFeasibility(constraints, flat.angles.value);
    fit.kkt.primal = fit.kkt.dual = 0;
    fit.solve.strategy = kFlat;
    Record(fit);
    LogRadiiResult radii;
    radii.log_radii = flat.log_radii;
    radii.gradient_max = 2 * fit.kkt.triangle_sum_residual;
    radii.solve.strategy = kFlat;
    Record(radii);
    if (options_.holonomy != HolonomyRule::kFree) {
      result_.intrinsic_lengths = result_.intrinsic.lengths;
      NoteMiss(options_, result_, &certificate_);
    }
    return Status();
  }

  Status FitAngles(const IntrinsicSurface& solved, const ConeTargets& targets) {
    job_.control.BeginStage("angles");
    const auto objective = AngleObjectiveOf(options_);
    if (!objective.ok()) return objective.status();
    const AngleConstraints constraints(t(), targets);
    const AngleFitProblem problem = {constraints, solved.angles.value, options_.epsilon,
                                     StartOfFit(constraints)};
    AngleFitResult fit;
    Status status = Fit(problem, *objective, &fit);
    result_.infeasibility = std::move(fit.infeasibility);
    Record(fit);
    result_.angles = std::move(fit.angles);
    // Where a fit has come to no end its multipliers are far from those of any triangulation.
    result_.multipliers = status.ok() ? std::move(fit.multipliers) : Eigen::VectorXd();
    return status;
  }

  /// By the solver that was asked for and, where that decides nothing on the input's own triangles,
  /// by the interior point (unless no map is wanted then): at once where the dual has wandered before and
  /// that costs little.
  Status Fit(const AngleFitProblem& problem, const std::shared_ptr<const AngleObjective>& objective,
             AngleFitResult* fit) {
    Status status;
    const bool at_once = start_ == FitStart::kAfterWandering && InteriorPointIsCheap(t()) &&
                         !objective->MeasuresTheta();
    if (at_once && Decides(problem, objective, fit, &status)) return status;
    status = FitAsAsked(problem, objective, fit);
    const bool undecided =
        status.code() == StatusCode::kNotConverged && !at_once && job_.dual != DualFit::kOrNothing;
    if (undecided && result_.intrinsic.flips.empty()) Decides(problem, objective, fit, &status);
    return status;
  }

  Status FitAsAsked(const AngleFitProblem& problem,
                    const std::shared_ptr<const AngleObjective>& objective, AngleFitResult* fit) {
    const auto method = MakeAngleSolver(options_.angle_solver, AngleSolverOptions());
    if (!method.ok()) return method.status();
    return cirque::FitAngles(problem, objective, **method, WithPatience(), fit);
  }

  /// The job's control, which also stops a fit by the default solver that wanders.
  SolveControl WithPatience() const {
    SolveControl control = job_.control;
    if (options_.angle_solver != ParameterizeOptions().angle_solver) return control;
    control.callback = [asked = job_.control.callback,
                        watch = WanderingWatch(InteriorPointIsCheap(t()))](
                           const IterationRecord& step, const Eigen::VectorXd& y) mutable {
      if (asked && asked(step, y) == CallbackAction::kStop) return CallbackAction::kStop;
      return watch.Wanders(step) ? CallbackAction::kStop : CallbackAction::kContinue;
    };
    return control;
  }

  void Record(const AngleFitResult& fit) {
    AngleFitSummary& summary = Fill(&certificate_.angle_fit);
    summary.smallest_angle = fit.kkt.smallest_angle;
    summary.smallest_theta = fit.kkt.smallest_theta;
    summary.epsilon = fit.angles.epsilon;
    summary.triangle_sum_residual = fit.kkt.triangle_sum_residual;
    summary.vertex_sum_residual = fit.kkt.vertex_sum_residual;
    summary.angle_primal = fit.kkt.primal;
    summary.angle_dual = fit.kkt.dual;
    summary.angle_gap = fit.kkt.RelativeGap();
    summary.angle_iterations = fit.solve.num_iterations();
    summary.angle_factorizations = fit.solve.factorizations;
    summary.angle_cg_iterations = fit.solve.cg_iterations;
    summary.solver = fit.solve.strategy;
    summary.gradients = GradientsOf(fit.solve);
  }

  /// Another round changes the triangulation in a few places: its multipliers are nearly the last
  /// round's.
  const Eigen::VectorXd* StartOfFit(const AngleConstraints& constraints) const {
    const bool fits =
        start_ == FitStart::kMultipliers && result_.multipliers.size() == constraints.num_rows();
    return fits ? &result_.multipliers : nullptr;
  }

  /// The dual can wander where no coherent angles exist, or hardly any, before its iterates prove
  /// it. The interior point then decides: angles or a proof. Which angles there are at all does not
  /// depend on the objective, if it should be one that the interior point does not take.
  bool Decides(const AngleFitProblem& problem,
               const std::shared_ptr<const AngleObjective>& objective, AngleFitResult* fit,
               Status* status) {
    const auto method = MakeAngleSolver(kRetry);
    if (!method.ok()) return false;
    AngleFitResult retried;
    Status again = cirque::FitAngles(problem, objective, **method, job_.control, &retried);
    if (again.code() == StatusCode::kInvalidInput) {
      const auto quadratic = AngleObjectives().Find(kRetryObjective);
      again = cirque::FitAngles(problem, *quadratic, **method, job_.control, &retried);
    }
    if (!again.ok() && again.code() != StatusCode::kInfeasible) return false;
    Fill(&certificate_.angle_fit).angle_fit_retried = 1;
    *fit = std::move(retried);
    *status = again;
    return true;
  }

  Status SolveRadii(const SolverStrategy& strategy, RadiiSystem* system) {
    LogRadiiResult radii;
    job_.control.BeginStage("radii");
    Status status = SolveLogRadii(t(), result_.angles, strategy, job_.control, system, &radii);
    Record(radii);
    result_.log_radii = std::move(radii.log_radii);
    return status;
  }

  void Record(const LogRadiiResult& radii) {
    RadiiSummary& summary = Fill(&certificate_.radii);
    const Eigen::VectorXd& rho = radii.log_radii.value;
    summary.radii_gradient = radii.gradient_max;
    summary.radii_primal = radii.energy;
    summary.radii_dual = radii.dual_energy;
    summary.radii_gap = radii.RelativeGap();
    summary.radii_iterations = radii.solve.num_iterations();
    summary.radii_factorizations = radii.solve.factorizations + radii.start.factorizations;
    summary.radii_cg_iterations = radii.solve.cg_iterations + radii.start.cg_iterations;
    summary.log_radius_range = rho.maxCoeff() - rho.minCoeff();
    summary.solver = radii.solve.strategy;
    summary.gradients = GradientsOf(radii.solve);
  }

  const FlattenJob& job_;
  const ParameterizeOptions& options_;
  const FitStart start_;
  Certificate& certificate_;
  FlatSurface& result_;
};

}  // namespace

bool InteriorPointIsCheap(const Triangulation& t) { return t.num_faces() <= kFewFaces; }

Status SolveFlatMetric(const FlattenJob& job, FitStart start, Certificate* certificate,
                       FlatSurface* result) {
  return FlatMetricSolve(job, start, certificate, result).Run();
}

}  // namespace cirque

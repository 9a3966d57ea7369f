#include <limits>
#include <utility>

#include <ceres/gradient_problem.h>
#include <ceres/gradient_problem_solver.h>
#include <fmt/format.h>

#include "cirque/solver/ceres_adapter.h"
#include "cirque/solver/ceres_strategies.h"

namespace cirque {
namespace {

constexpr int kMostBfgsParameters = 2000;
constexpr double kMostRank = 1000;
constexpr double kLeastScaled = 1e-3;  ///< of the Hessian's mean diagonal entry
constexpr int kMaxIdle = 100;          ///< gradients do not fall at every step of these methods

/// The run's energy for a GradientProblem, which would delete the energy itself. Counts, and
/// remembers the last gradient, which is often that of the iterate accepted next.
class CountedEnergy final : public ceres::FirstOrderFunction {
 public:
  /// The parameters are x divided by `scale`.
  CountedEnergy(SolveRun* run, Eigen::VectorXd scale) : run_(run), scale_(std::move(scale)) {}

  Eigen::VectorXd FromX(const Eigen::VectorXd& x) const { return x.cwiseQuotient(scale_); }
  Eigen::VectorXd ToX(const Eigen::VectorXd& y) const { return y.cwiseProduct(scale_); }

  /// From here on values are differences from that at `base`, (g(base) + g(x)) / 2 . (x - base):
  /// near the minimum the trapezoidal rule is better than the difference of two large values.
  void MeasureFrom(const Eigen::VectorXd& base) {
    base_ = base;
    run_->Gradient(base, &base_gradient_);
  }

  int NumParameters() const override { return run_->energy().NumParameters(); }

  bool Evaluate(const double* y, double* value, double* gradient) const override {
    const bool is_difference = base_.size() > 0;
    point_ = ToX(Eigen::Map<const Eigen::VectorXd>(y, NumParameters()));
    is_defined_ = is_difference
                      ? run_->Gradient(point_, &gradient_)
                      : run_->Value(point_.data(), value, gradient ? &gradient_ : nullptr);
    has_gradient_ = is_difference || gradient;
    if (is_difference) *value = 0.5 * (base_gradient_ + gradient_).dot(point_ - base_);
    if (gradient) Eigen::Map<Eigen::VectorXd>(gradient, NumParameters()) = ToX(gradient_);
    return is_defined_;
  }

  bool Gradient(const Eigen::VectorXd& x, Eigen::VectorXd* gradient) const {
    if (!has_gradient_ || point_ != x) return run_->Gradient(x, gradient);
    *gradient = gradient_;
    return is_defined_;
  }

 private:
  SolveRun* run_;
  const Eigen::VectorXd scale_;
  Eigen::VectorXd base_, base_gradient_;  ///< empty: values are the energy's
  mutable Eigen::VectorXd point_, gradient_;
  mutable bool is_defined_ = false, has_gradient_ = false;
};

/// One over the root of the Hessian's diagonal at x, bounded where that is small; or ones.
Eigen::VectorXd Scale(ParameterScaling scaling, const Eigen::VectorXd& x, SolveRun* run) {
  SparseMatrix lower;
  if (scaling == ParameterScaling::kNone || !run->Hessian(x, &lower))
    return Eigen::VectorXd::Ones(x.size());
  const Eigen::VectorXd diagonal = lower.diagonal();
  const double least = kLeastScaled * diagonal.mean();
  if (!(least > 0)) return Eigen::VectorXd::Ones(x.size());
  return diagonal.cwiseMax(least).cwiseSqrt().cwiseInverse();
}

ceres::GradientProblemSolver::Options SolverOptions(const CeresLineSearchOptions& options) {
  ceres::GradientProblemSolver::Options result;
  result.line_search_direction_type = options.direction;
  result.line_search_type = options.line_search;
  result.nonlinear_conjugate_gradient_type = ceres::POLAK_RIBIERE;
  result.max_lbfgs_rank = options.max_lbfgs_rank;
  result.min_line_search_step_size = std::numeric_limits<double>::min();
  result.max_num_iterations = std::numeric_limits<int>::max() - 1;
  result.max_solver_time_in_seconds = options.max_seconds;
  result.function_tolerance = result.gradient_tolerance = result.parameter_tolerance = 0;
  result.logging_type = ceres::SILENT;
  result.update_state_every_iteration = true;
  return result;
}

void SolveInRounds(const CeresLineSearchOptions& options, const Eigen::VectorXd& gradient,
                   SolveRun* run, Eigen::VectorXd* x) {
  auto* energy = new CountedEnergy(run, Scale(options.scaling, *x, run));
  const ceres::GradientProblem problem(energy);
  Eigen::VectorXd state;
  CeresWatch watch(
      run,
      [energy](const Eigen::VectorXd& p, Eigen::VectorXd* g) { return energy->Gradient(p, g); },
      [&] { return energy->ToX(state); }, gradient, kMaxIdle, x);
  ceres::GradientProblemSolver::Options solver_options = SolverOptions(options);
  solver_options.callbacks.push_back(&watch);
  ceres::GradientProblemSolver::Summary summary;
  while (true) {
    state = energy->FromX(*x);
    watch.BeginRound();
    ceres::Solve(solver_options, problem, state.data(), &summary);
    if (!watch.AnotherRoundHelps(summary.message)) return;
    energy->MeasureFrom(*x);
  }
}

}  // namespace

const OptionTable<CeresLineSearchOptions>& CeresLineSearchOptionTable() {
  using O = CeresLineSearchOptions;
  static const OptionTable<O> kTable(
      "ceres_line_search",
      Joined<O>(LimitOptions<O>(),
                {{"direction", &O::direction, "how steps are chosen"},
                 {"line_search", &O::line_search, "which steps are accepted"},
                 {"scaling", &O::scaling, "of the parameters"},
                 Option<O>("max_lbfgs_rank", &O::max_lbfgs_rank, "steps that lbfgs remembers")
                     .Between(1, kMostRank)}));
  return kTable;
}

StatusOr<std::shared_ptr<const SolverStrategy>> MakeCeresLineSearch(const OptionMap& map) {
  CeresLineSearchOptions options;
  if (Status s = CeresLineSearchOptionTable().Set(map, &options); !s.ok()) return s;
  if (options.line_search == ceres::ARMIJO &&
      (options.direction == ceres::LBFGS || options.direction == ceres::BFGS)) {
    return Status::InvalidInput(
        fmt::format("ceres_line_search: line_search = 'armijo' does not go with direction = '{}'; "
                    "use wolfe",
                    ToWord(options.direction)));
  }
  return std::shared_ptr<const SolverStrategy>(std::make_shared<CeresLineSearchStrategy>(options));
}

SolveSummary CeresLineSearchStrategy::Minimize(const Energy& energy, const SolveControl& control,
                                               Eigen::VectorXd* x) const {
  SolveRun run("ceres_line_search " + ToWord(options_.direction), options_, control, energy);
  if (options_.direction == ceres::BFGS && x->size() > kMostBfgsParameters) {
    run.End(Termination::kUnsupported,
            fmt::format("bfgs keeps a dense matrix: {} parameters > {}; use lbfgs", x->size(),
                        kMostBfgsParameters));
    return run.Finish(*x);
  }
  Eigen::VectorXd gradient;
  if (run.RequireSmooth() && run.Begin(*x, &gradient) && run.Continue(gradient)) {
    SolveInRounds(options_, gradient, &run, x);
  }
  return run.Finish(*x);
}

}  // namespace cirque

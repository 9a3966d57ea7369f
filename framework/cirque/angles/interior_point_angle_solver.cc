#include "cirque/angles/interior_point_angle_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "cirque/angles/angle_program.h"
#include "cirque/angles/infeasibility.h"
#include "cirque/core/solve_summary.h"
#include "cirque/linear/registry.h"

namespace cirque {
namespace {

constexpr double kToBoundary = 0.995;  ///< share of the way to the nearest bound that a step takes
constexpr double kShortestStep = 1e-8;
constexpr double kAngleRounding = 1e-13;                                ///< [rad]
constexpr double kFirstShift = 1e-14, kRaise = 100, kLastShift = 1e-4;  ///< of the mean diagonal

/// The largest step in [0, 1] along d that keeps v >= 0.
double StepToBoundary(const Eigen::VectorXd& v, const Eigen::VectorXd& d) {
  double step = 1;
  for (Eigen::Index i = 0; i < v.size(); ++i) {
    if (d[i] < 0) step = std::min(step, -v[i] / d[i]);
  }
  return step;
}

double MaxNorm(const Eigen::VectorXd& v) { return v.size() ? v.lpNorm<Eigen::Infinity>() : 0; }

/// Angles (and ranged sums), multipliers, slacks and the slacks' multipliers, or a step of them.
struct Point {
  Eigen::VectorXd x, y, s, z;
};

class InteriorPointSolve {
 public:
  InteriorPointSolve(AngleProgram* program, const AngleConstraints& constraints,
                     const InteriorPointOptions& options, const SolveControl& control,
                     InfeasibilityWatch* watch)
      : program_(*program),
        constraints_(constraints),
        options_(options),
        control_(control),
        watch_(*watch),
        assembler_(constraints),
        cholesky_(MakeCholesky(options.linear_solver)) {
    summary_.strategy = "interior_point";
  }

  SolveSummary Run() {
    Start();
    while (Continue()) Iterate();
    summary_.final_value = program_.value();
    summary_.final_gradient_max = MaxNorm(equality_);
    summary_.total_seconds = timer_.Seconds();
    return std::move(summary_);
  }

  Eigen::VectorXd Angles() const {
    return at_.x.head(constraints_.triangulation().num_halfedges());
  }
  const Eigen::VectorXd& multipliers() const { return at_.y; }

 private:
  void Start() {
    at_.x = program_.InteriorPoint();
    program_.Linearize(at_.x);
    at_.y = Eigen::VectorXd::Zero(constraints_.num_rows());
    at_.s = program_.Slacks(at_.x).cwiseMax(1e-3);
    const double scale = 1e-2 * (1e-2 + program_.weight().cwiseMin(1e2).mean());
    at_.z = scale * at_.s.cwiseInverse();
    ComputeResiduals();
    summary_.initial_value = program_.value();
    summary_.initial_gradient_max = MaxNorm(equality_);
  }

  void ComputeResiduals() {
    const Timer timer;
    stationarity_ =
        program_.slope() - program_.ApplyTransposedB(at_.y) - program_.ApplyTransposedG(at_.z);
    equality_ = program_.EqualityResidual(at_.x);
    inequality_ = program_.Slacks(at_.x) - at_.s;
    // Slacks become much smaller than the rounding of angles, and must not be corrected by it.
    inequality_ = (inequality_.array().abs() > kAngleRounding).select(inequality_, 0.0);
    ++summary_.gradient_evaluations;
    summary_.evaluation_seconds += timer.Seconds();
  }

  bool IsOptimal() const {
    const Eigen::VectorXd slope_scale = program_.weight().array() + 1 + MaxNorm(at_.y);
    return MaxNorm(equality_) <= options_.feasibility_tolerance &&
           MaxNorm(inequality_) <= options_.feasibility_tolerance &&
           MaxNorm(stationarity_.cwiseQuotient(slope_scale)) <= options_.feasibility_tolerance &&
           at_.s.dot(at_.z) <= options_.gap_tolerance * (1 + std::abs(program_.value()));
  }

  bool Continue() {
    if (summary_.termination != Termination::kNotRun) return false;
    if (IsOptimal()) {
      End(Termination::kConverged, fmt::format("complementarity {:.1e}", at_.s.dot(at_.z)));
    } else if (control_.cancelled && control_.cancelled->load()) {
      End(Termination::kCancelled, "cancelled by the caller");
    } else if (summary_.num_iterations() >= options_.max_iterations) {
      End(Termination::kIterationLimit, fmt::format("{} iterations", options_.max_iterations));
    } else if (timer_.Seconds() > options_.max_seconds) {
      End(Termination::kTimeLimit, fmt::format("{} s", options_.max_seconds));
    }
    return summary_.termination == Termination::kNotRun;
  }

  void End(Termination termination, std::string message) {
    summary_.termination = termination;
    summary_.message = std::move(message);
  }

  /// Factors B D^-1 B', shifted as little as makes it positive definite in floating point.
  bool Factorize(const AngleProgram::Blocks& blocks) {
    const Timer evaluation;
    blocks.NormalMatrix(&assembler_, &matrix_);
    const double mean = matrix_.diagonal().mean();
    // With every vertex fixed, y_f = 1, y_v = -1 is a kernel, which the right side is orthogonal
    // to.
    const bool gauge = constraints_.HasGauge() &&
                       program_.num_variables() == constraints_.triangulation().num_halfedges();
    if (gauge) matrix_.coeffRef(constraints_.num_faces(), constraints_.num_faces()) *= 2;
    ++summary_.hessian_evaluations;
    summary_.evaluation_seconds += evaluation.Seconds();
    const Timer timer;
    bool factored = cholesky_->Factorize(matrix_);
    for (double shift = kFirstShift; !factored && shift <= kLastShift; shift *= kRaise) {
      for (int i = 0; i < matrix_.cols(); ++i) matrix_.coeffRef(i, i) += shift * mean;
      factored = cholesky_->Factorize(matrix_);
    }
    summary_.symbolic_analyses = cholesky_->symbolic_analyses();
    summary_.factorizations = cholesky_->factorizations();
    summary_.factorization_seconds += timer.Seconds();
    return factored;
  }

  /// Newton's step towards s z = target, the other residuals towards 0. `complementarity` is s z -
  /// target.
  Point Direction(const AngleProgram::Blocks& blocks, const Eigen::VectorXd& complementarity) {
    const Timer timer;
    Point d;
    const Eigen::VectorXd scaled =
        -(complementarity + at_.z.cwiseProduct(inequality_)).cwiseQuotient(at_.s);
    const Eigen::VectorXd right = program_.ApplyTransposedG(scaled) - stationarity_;
    d.y = cholesky_->Solve(-equality_ - program_.ApplyB(blocks.Solve(right)));
    const Eigen::VectorXd full = right + program_.ApplyTransposedB(d.y);
    d.x = blocks.Solve(full);
    d.s = blocks.ApplyGToSolution(full, d.x) + inequality_;
    d.z = -(complementarity + at_.z.cwiseProduct(d.s)).cwiseQuotient(at_.s);
    ++summary_.linear_solves;
    summary_.solve_seconds += timer.Seconds();
    return d;
  }

  /// Mehrotra's target: the plain Newton step says how far complementarity can fall at once, and
  /// what its product of steps leaves over.
  Eigen::VectorXd CorrectedComplementarity(const Point& affine) const {
    const Eigen::VectorXd product = at_.s.cwiseProduct(at_.z);
    if (product.size() == 0) return product;
    const double step = std::min(StepToBoundary(at_.s, affine.s), StepToBoundary(at_.z, affine.z));
    const double now = product.mean();
    const double then = (at_.s + step * affine.s).dot(at_.z + step * affine.z) / product.size();
    const double target = std::pow(then / now, 3) * now;
    return (product + affine.s.cwiseProduct(affine.z)).array() - target;
  }

  void Iterate() {
    const AngleProgram::Blocks blocks(program_, at_.z.cwiseQuotient(at_.s));
    if (!Factorize(blocks)) {
      return End(Termination::kStalled, "the normal matrix could not be made positive definite");
    }
    const Point affine = Direction(blocks, at_.s.cwiseProduct(at_.z));
    const Point d = Direction(blocks, CorrectedComplementarity(affine));
    const double reach = std::min(StepToBoundary(at_.s, d.s), StepToBoundary(at_.z, d.z));
    const double step = reach < 1 ? kToBoundary * reach : 1;
    const bool finite = d.x.allFinite() && d.y.allFinite() && d.z.allFinite();
    if (!finite) return End(Termination::kStalled, "the step is not finite");
    if (step < kShortestStep) {
      watch_.Found(at_.y + d.y);
      return End(Termination::kStalled, "steps became too short");
    }
    Move(d, step);
    Record(step);
  }

  void Move(const Point& d, double step) {
    at_.x += step * d.x;
    at_.y += step * d.y;
    at_.s += step * d.s;
    at_.z += step * d.z;
    program_.Linearize(at_.x);
    ComputeResiduals();
  }

  void Record(double step) {
    IterationRecord record;
    record.iteration = summary_.num_iterations() + 1;
    record.value = program_.value();
    record.gradient_max = std::max(MaxNorm(equality_), MaxNorm(stationarity_));
    record.step_length = step;
    record.seconds = timer_.Seconds();
    summary_.iterations.push_back(record);
    summary_.x_changed = true;
    if (control_.callback && control_.callback(record, Angles()) == CallbackAction::kStop) {
      End(Termination::kStoppedByCaller, "the iteration callback asked to stop");
    } else if (watch_.Found(at_.y)) {
      End(Termination::kStoppedByCaller, "infeasible");
    }
  }

  AngleProgram& program_;
  const AngleConstraints& constraints_;
  const InteriorPointOptions& options_;
  const SolveControl& control_;
  InfeasibilityWatch& watch_;
  EdgeBlockAssembler assembler_;
  SparseMatrix matrix_;  ///< the normal matrix, its pattern kept from step to step
  std::unique_ptr<SparseCholesky> cholesky_;
  Timer timer_;
  SolveSummary summary_;
  Point at_;
  Eigen::VectorXd stationarity_, equality_, inequality_;
};

}  // namespace

const OptionTable<InteriorPointOptions>& InteriorPointOptionTable() {
  using O = InteriorPointOptions;
  constexpr double kMany = std::numeric_limits<int>::max();
  static const OptionTable<O> kTable(
      "interior_point",
      {Option<O>("max_iterations", &O::max_iterations, "steps").Between(0, kMany),
       Option<O>("gap_tolerance", &O::gap_tolerance, "largest relative complementarity at the end")
           .Between(0, 1),
       Option<O>("feasibility_tolerance", &O::feasibility_tolerance, "largest residual at the end")
           .Between(0, 1),
       Option<O>("max_seconds", &O::max_seconds, "wall time").Between(0, 1e9).Unit("s"),
       Option<O>("linear_solver", &O::linear_solver, "sparse Cholesky; default: the first")
           .OneOf(LinearSolvers().Names())});
  return kTable;
}

Status InteriorPointAngleSolver::Fit(const AngleFitProblem& problem,
                                     const std::shared_ptr<const AngleObjective>& objective,
                                     const SolveControl& control, AngleFitResult* result) const {
  if (objective->MeasuresTheta()) {
    return Status::InvalidInput(
        "interior_point fits objectives of corner angles only, such as quadratic and entropy, not "
        "barrier: use another angle solver for this objective");
  }
  AngleProgram program(problem, *objective);
  InfeasibilityWatch watch(problem.constraints, objective->Margin(problem.epsilon));
  InteriorPointSolve solve(&program, problem.constraints, options_, control, &watch);
  result->solve = solve.Run();
  return FinishFit(problem, *objective, watch.certificate(), solve.Angles(), solve.multipliers(),
                   result);
}

}  // namespace cirque

#include "cirque/equivalence/solve_log_scales.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "cirque/equivalence/double_surface.h"
#include "cirque/equivalence/scale_path.h"
#include "cirque/equivalence/scaled_metric.h"
#include "cirque/math/compensated_sum.h"

namespace cirque {
namespace {

constexpr double kAcceptedResidual = 1e-10;  ///< [rad]
constexpr double kNearAngles = 1;            ///< [rad]: the solution's triangles, but for needles
constexpr int kLeastSolves = 2, kMostSolves = 12;  ///< each on a triangulation flipped anew
constexpr double kProgress = 0.5;                  ///< of the residual from solve to solve
constexpr int kPartsForOne = 10, kLeastParts = 100, kMostParts = 1000, kIdleParts = 50;

}  // namespace

ConeTargets FixedTargets(const Triangulation& t, const ConeTargets& targets) {
  const std::vector<bool> boundary = BoundaryVertices(t);
  double missing = kPi * t.num_faces(), width = 0;
  bool held = false;
  for (Index v = 0; v < t.num_vertices; ++v) {
    const bool free = boundary[v] && !targets.IsFixed(v);
    held = held || free;
    if (free) continue;
    missing -= targets.lower[v];
    width += targets.upper[v] - targets.lower[v];
  }
  const double fraction = held || width == 0 ? 0.5 : std::clamp(missing / width, 0.0, 1.0);
  ConeTargets fixed = targets;
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (targets.IsFixed(v) || boundary[v]) continue;
    fixed.lower[v] += fraction * (targets.upper[v] - targets.lower[v]);
    fixed.upper[v] = fixed.lower[v];
  }
  return fixed;
}

namespace {

/// What no scale can mend, rounding of the targets, is shared out: Newton's method would leave all of
/// it to the scale that is fixed.
void ObeyGaussBonnet(Index num_faces, ScaleTargets* targets) {
  const bool held = std::find(targets->parameter.begin(), targets->parameter.end(), kNone) !=
                    targets->parameter.end();
  const auto n = static_cast<int>(targets->angle_sum.size());
  if (held || n == 0) return;
  CompensatedSum missing;
  missing += kPi * num_faces;
  for (const double sum : targets->angle_sum) missing -= sum;
  targets->angle_sum.array() += missing.Value() / n;
}

using Flips = ConformalEquivalenceEnergy::Flips;

Flips FlipsOf(KeptEdges kept) { return kept == KeptEdges::kAll ? Flips::kNever : Flips::kPtolemy; }

/// One closed surface, or one with a boundary whose edges stay.
class LogScaleSolve {
 public:
  LogScaleSolve(const Triangulation& t, const EdgeLengths& lengths, ScaleTargets targets,
                Flips flips, LogScalesResult* result)
      : problem_(t, lengths, std::move(targets), flips), result_(*result) {
    result_.delaunay = problem_.start;
  }

  Status Run(const SolverStrategy& strategy, const SolveControl& control) {
    base_.assign(static_cast<std::size_t>(problem_.start.triangulation.num_vertices), 0);
    Status status = SolveFromBase(
        [&](const auto& energy, auto* u) { return strategy.Minimize(energy, control, u); });
    const bool exists = problem_.flips == Flips::kPtolemy && problem_.IsClosed();
    if (status.code() != StatusCode::kNotConverged || result_.residual <= kNearScaleResidual ||
        !exists || StoppedByTheCaller()) {
      return status;
    }
    LogScalesResult best = result_;
    for (const ScalePath path : {ScalePath::kFromZero, ScalePath::kTargets, ScalePath::kLengths}) {
      if (!FollowScalePath(problem_, path, control, &base_)) continue;
      status = SolveInSmallParts(control);
      if (status.code() != StatusCode::kNotConverged) return status;
      if (IsBeyondDigits()) return BeyondDigits();
      if (result_.residual < best.residual) best = result_;
    }
    result_ = std::move(best);
    return status;
  }

 private:
  /// By a limit of fewer iterations than are usual.
  bool StoppedByTheCaller() const {
    return result_.solve.termination == Termination::kIterationLimit &&
           result_.solve.num_iterations() < SolverLimits().max_iterations;
  }

  /// In solves that each count u from where the last one ended: what is left of it is small and has
  /// all its digits, where needles need them.
  template <class Minimize>
  Status SolveFromBase(const Minimize& minimize) {
    double last = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kMostSolves; ++i) {
      const ConformalEquivalenceEnergy energy = problem_.EnergyFrom(base_);
      Eigen::VectorXd u = Eigen::VectorXd::Zero(problem_.targets.angle_sum.size());
      result_.solve = minimize(energy, &u);
      if (result_.solve.termination == Termination::kCancelled) {
        return Status(StatusCode::kCancelled, "log scales: cancelled");
      }
      AdvanceScales(energy.ScaleOfVertices(u.data()), &base_);
      if (!MeasureScaledMetric(problem_, base_, &result_, &rounding_)) break;
      if (result_.residual <= kAcceptedResidual) return CheckTriangles();
      if (StoppedByTheCaller()) break;
      if (i >= kLeastSolves && !(result_.residual < kProgress * last)) break;
      last = result_.residual;
    }
    return Verdict();
  }

  /// Rounding excuses what is near the solution only: of the narrowest needles its bound is above all
  /// angles.
  Status Verdict() const {
    if (result_.residual <= std::min(rounding_.by_doubles, kNearScaleResidual))
      return CheckTriangles();
    return Status(StatusCode::kNotConverged,
                  fmt::format("log scales: angle sums miss their targets by {:.2e} rad: {}",
                              result_.residual, result_.solve.BriefReport()));
  }

  /// Whether what is missed is what rounding of lengths does to the angles of needles.
  bool IsBeyondDigits() const {
    return result_.residual <= std::min(rounding_.beyond_digits, kNearAngles);
  }

  Status BeyondDigits() const {
    const Eigen::VectorXd& u = result_.log_scale;
    return Status(
        StatusCode::kUnrepresentable,
        fmt::format("log scales: they range over {:.1f}, and some triangle's sides over "
                    "{:.1f} in their logarithms; its angles lie in digits that lengths "
                    "do not have, even with three times those of a double, which leaves angle "
                    "sums {:.2e} rad from their targets; add cones",
                    u.maxCoeff() - u.minCoeff(), rounding_.longest_needle, result_.residual));
  }

  /// The same in a few iterations at a time, whatever the residual after each: creases can be narrower
  /// than the spacing of doubles where u is large, and are met only by steps from beside them. Where the
  /// angles of needles are in the last digits, residuals rise and fall: the least one counts.
  Status SolveInSmallParts(const SolveControl& control) {
    const auto n = static_cast<int>(problem_.targets.angle_sum.size());
    const int most = std::clamp(kPartsForOne * n, kLeastParts, kMostParts);
    double least = std::numeric_limits<double>::infinity();
    VertexScales best = base_;
    result_.solve = {};
    for (int i = 0, since_least = 0; i < most && since_least < kIdleParts; ++i) {
      const ConformalEquivalenceEnergy energy = problem_.EnergyFrom(base_);
      Eigen::VectorXd u = Eigen::VectorXd::Zero(n);
      SolverLimits limits;
      limits.max_iterations = kScaleIterationsInPart;
      SolveSummary part = MinimizeScalesRobustly(energy, problem_.IsClosed(), limits, control, &u);
      const bool moved = part.num_iterations() > 0;
      result_.solve = Joined(std::move(result_.solve), std::move(part));
      if (result_.solve.termination == Termination::kCancelled) {
        return Status(StatusCode::kCancelled, "log scales: cancelled");
      }
      AdvanceScales(energy.ScaleOfVertices(u.data()), &base_);
      if (!MeasureScaledMetric(problem_, base_, &result_, &rounding_)) break;
      if (result_.residual <= kAcceptedResidual) return CheckTriangles();
      since_least = result_.residual < kLessResidual * least ? 0 : since_least + 1;
      if (result_.residual < least) best = base_, least = result_.residual;
      if (!moved) break;
    }
    base_ = std::move(best);
    MeasureScaledMetric(problem_, base_, &result_, &rounding_);
    return Verdict();
  }

  /// A solve that went on from where another had ended.
  static SolveSummary Joined(SolveSummary before, SolveSummary after) {
    before.iterations.insert(before.iterations.end(), after.iterations.begin(),
                             after.iterations.end());
    after.iterations = std::move(before.iterations);
    after.factorizations += before.factorizations;
    return after;
  }

  /// Beside edges that are not flipped triangles may be degenerate.
  Status CheckTriangles() const {
    const double* angle = result_.angles.value.data();
    for (Index h = 0; h < result_.angles.value.size(); ++h) {
      if (angle[h] > 0) continue;
      return Status(StatusCode::kNotConverged,
                    fmt::format("log scales: with the edges that are kept face {} (0-based) of the "
                                "flipped triangulation has an angle of 0",
                                Triangulation::Face(h)));
    }
    return Status();
  }

  const ScaleProblem problem_;
  VertexScales base_;       ///< from which the solves count u
  ScaleRounding rounding_;  ///< of the metric there
  LogScalesResult& result_;
};

Status SolveDoubled(const Triangulation& t, const EdgeLengths& lengths, const ScaleTargets& single,
                    const SolverStrategy& strategy, const SolveControl& control,
                    LogScalesResult* result) {
  const DoubledSurface doubled = DoubleSurface(t, lengths);
  ScaleTargets targets;
  for (const Index v : doubled.original) targets.parameter.push_back(single.parameter[v]);
  targets.angle_sum = 2 * single.angle_sum;
  ObeyGaussBonnet(doubled.triangulation.num_faces(), &targets);
  result->doubled = true;
  Status status = LogScaleSolve(doubled.triangulation, doubled.lengths, std::move(targets),
                                Flips::kPtolemy, result)
                      .Run(strategy, control);
  result->log_scale.conservativeResize(t.num_vertices);
  return status;
}

}  // namespace

Status SolveLogScales(const Triangulation& t, const EdgeLengths& lengths,
                      const ConeTargets& targets, KeptEdges kept, const SolverStrategy& strategy,
                      const SolveControl& control, LogScalesResult* result) {
  *result = LogScalesResult();
  const std::vector<bool> on_boundary = BoundaryVertices(t);
  const bool closed = std::find(on_boundary.begin(), on_boundary.end(), true) == on_boundary.end();
  ScaleTargets scales = TargetsOfScales(FixedTargets(t, targets));
  if (kept == KeptEdges::kNoEdge && !closed) {
    return SolveDoubled(t, lengths, scales, strategy, control, result);
  }
  ObeyGaussBonnet(t.num_faces(), &scales);
  return LogScaleSolve(t, lengths, std::move(scales), FlipsOf(kept), result).Run(strategy, control);
}

}  // namespace cirque

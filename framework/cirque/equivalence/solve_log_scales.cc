#include "cirque/equivalence/solve_log_scales.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/parallel.h"
#include "cirque/equivalence/double_surface.h"
#include "cirque/equivalence/laplacian_newton.h"
#include "cirque/intrinsic/metric_delaunay.h"
#include "cirque/intrinsic/ptolemy_complex.h"
#include "cirque/math/compensated_sum.h"
#include "cirque/solver/newton_strategies.h"

namespace cirque {
namespace {

constexpr double kAcceptedResidual = 1e-10;  ///< [rad]
constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();
constexpr double kNearResidual = 1e-6;  ///< [rad]: the solution, but for rounding
constexpr double kFirstStepOnPath = 0.1, kLeastStepOnPath = 1e-6;
constexpr int kLeastSolvesOnPath = 20, kMostSolvesOnPath = 300, kMostStepsOnPath = 20,
              kMostStepsToPath = 200;
constexpr int kIterationsInPart = 3, kPartsForOne = 10, kLeastParts = 100, kMostParts = 1000,
              kIdleParts = 50, kIdlePartsOnPath = 5;
constexpr double kLessResidual = 0.9;  ///< of a part that is not idle
constexpr double kNearAngles = 1;      ///< [rad]: the solution's triangles, but for needles
/// Of the logarithms of lengths, relatively: a few units of double-double, after hundreds of flips.
constexpr double kExtendedRounding = 0x1p-100;
constexpr int kUnknownsOnPath = 200000;            ///< in all solves together
constexpr int kLeastSolves = 2, kMostSolves = 12;  ///< each on a triangulation flipped anew
constexpr double kProgress = 0.5;                  ///< of the residual from solve to solve

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

IntrinsicTriangulation AsItIs(const Triangulation& t, const EdgeLengths& lengths) {
  IntrinsicTriangulation same{t, lengths, {}, std::vector<Index>(t.num_edges())};
  std::iota(same.edge_of_input.begin(), same.edge_of_input.end(), 0);
  return same;
}

/// One closed surface, or one with a boundary whose edges stay.
class LogScaleSolve {
 public:
  LogScaleSolve(const Triangulation& t, const EdgeLengths& lengths, ScaleTargets targets,
                Flips flips, LogScalesResult* result)
      : t_(t),
        flips_(flips),
        start_(flips == Flips::kNever ? AsItIs(t, lengths) : MakeDelaunayOfMetric(t, lengths)),
        targets_(std::move(targets)),
        result_(*result) {
    log_lengths_ = start_.lengths.value.array().log();
    result_.delaunay = start_;
  }

  Status Run(const SolverStrategy& strategy, const SolveControl& control) {
    base_.assign(static_cast<std::size_t>(t_.num_vertices), 0);
    Status status = SolveFromBase(
        [&](const auto& energy, auto* u) { return strategy.Minimize(energy, control, u); });
    const bool exists = flips_ == Flips::kPtolemy && IsClosed();
    if (status.code() != StatusCode::kNotConverged || result_.residual <= kNearResidual ||
        !exists || StoppedByTheCaller()) {
      return status;
    }
    LogScalesResult best = result_;
    for (const Path path : {Path::kNone, Path::kTargets, Path::kLengths}) {
      if (!Follow(path, control)) continue;
      status = SolveInSmallParts(control);
      if (status.code() != StatusCode::kNotConverged) return status;
      if (IsBeyondDigits()) return BeyondDigits();
      if (result_.residual < best.residual) best = result_;
    }
    result_ = std::move(best);
    return status;
  }

 private:
  using Scales = std::vector<DoubleDouble>;  ///< V

  /// What leads from a problem that is easy to the one that is asked.
  enum class Path { kNone, kTargets, kLengths };

  /// By a limit of fewer iterations than are usual.
  bool StoppedByTheCaller() const {
    return result_.solve.termination == Termination::kIterationLimit &&
           result_.solve.num_iterations() < SolverLimits().max_iterations;
  }

  bool IsClosed() const {
    return std::find(t_.twin.begin(), t_.twin.end(), kNone) == t_.twin.end();
  }

  ConformalEquivalenceEnergy Energy() const {
    return {start_.triangulation, log_lengths_, targets_, flips_, base_};
  }

  /// Where the metric is Delaunay throughout, beside no edge that is kept, no weight is below 0.
  SolveSummary MinimizeRobustly(const ConformalEquivalenceEnergy& energy,
                                const SolverLimits& limits, const SolveControl& control,
                                Eigen::VectorXd* u) const {
    if (IsClosed() && u->size() <= kMostLaplacianUnknowns) {
      return MinimizeByLaplacians(energy, limits, control, u);
    }
    return NewtonStrategy({limits, ""}).Minimize(energy, control, u);
  }

  /// In solves that each count u from where the last one ended: what is left of it is small and has
  /// all its digits, where needles need them.
  template <class Minimize>
  Status SolveFromBase(const Minimize& minimize) {
    double last = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kMostSolves; ++i) {
      const ConformalEquivalenceEnergy energy = Energy();
      Eigen::VectorXd u = Eigen::VectorXd::Zero(targets_.angle_sum.size());
      result_.solve = minimize(energy, &u);
      if (result_.solve.termination == Termination::kCancelled) {
        return Status(StatusCode::kCancelled, "log scales: cancelled");
      }
      Advance(energy.ScaleOfVertices(u.data()), &base_);
      if (!TakeAnew()) break;
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
    if (result_.residual <= std::min(rounding_, kNearResidual)) return CheckTriangles();
    return Status(StatusCode::kNotConverged,
                  fmt::format("log scales: angle sums miss their targets by {:.2e} rad: {}",
                              result_.residual, result_.solve.BriefReport()));
  }

  /// Whether what is missed is what rounding of lengths does to the angles of needles.
  bool IsBeyondDigits() const { return result_.residual <= std::min(beyond_digits_, kNearAngles); }

  Status BeyondDigits() const {
    const Eigen::VectorXd& u = result_.log_scale;
    return Status(StatusCode::kUnrepresentable,
                  fmt::format("log scales: they range over {:.1f}, and some triangle's sides over "
                              "{:.1f} in their logarithms; its angles lie in digits that lengths "
                              "do not have, even with twice those of a double, which leaves angle "
                              "sums {:.2e} rad from their targets; add cones",
                              u.maxCoeff() - u.minCoeff(), longest_needle_, result_.residual));
  }

  /// The same in a few iterations at a time, whatever the residual after each: creases can be narrower
  /// than the spacing of doubles where u is large, and are met only by steps from beside them. Where the
  /// angles of needles are in the last digits, residuals rise and fall: the least one counts.
  Status SolveInSmallParts(const SolveControl& control) {
    const auto n = static_cast<int>(targets_.angle_sum.size());
    const int most = std::clamp(kPartsForOne * n, kLeastParts, kMostParts);
    double least = std::numeric_limits<double>::infinity();
    Scales best = base_;
    result_.solve = {};
    for (int i = 0, since_least = 0; i < most && since_least < kIdleParts; ++i) {
      const ConformalEquivalenceEnergy energy = Energy();
      Eigen::VectorXd u = Eigen::VectorXd::Zero(n);
      SolverLimits limits;
      limits.max_iterations = kIterationsInPart;
      SolveSummary part = MinimizeRobustly(energy, limits, control, &u);
      const bool moved = part.num_iterations() > 0;
      result_.solve = Joined(std::move(result_.solve), std::move(part));
      if (result_.solve.termination == Termination::kCancelled) {
        return Status(StatusCode::kCancelled, "log scales: cancelled");
      }
      Advance(energy.ScaleOfVertices(u.data()), &base_);
      if (!TakeAnew()) break;
      if (result_.residual <= kAcceptedResidual) return CheckTriangles();
      since_least = result_.residual < kLessResidual * least ? 0 : since_least + 1;
      if (result_.residual < least) best = base_, least = result_.residual;
      if (!moved) break;
    }
    base_ = std::move(best);
    TakeAnew();
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

  static void Advance(const Eigen::VectorXd& by, Scales* scales) {
    for (std::size_t v = 0; v < scales->size(); ++v) {
      (*scales)[v] = (*scales)[v] + by[static_cast<Eigen::Index>(v)];
    }
  }

  /// The energy at a fraction of a path: angle sums on a straight line from the surface's own to the
  /// targets; or lengths to the power of the fraction, at first all alike, with the targets.
  ConformalEquivalenceEnergy At(Path path, double fraction, const Eigen::VectorXd& missing) const {
    if (path == Path::kLengths) {
      return {start_.triangulation, fraction * log_lengths_, targets_, flips_, base_};
    }
    ScaleTargets now = targets_;
    now.angle_sum -= (1 - fraction) * missing;
    return {start_.triangulation, log_lengths_, now, flips_, base_};
  }

  /// Leads base_ along a path of problems whose scales change smoothly: where these are as large as a
  /// hundred, E is all but linear between narrow creases, and Newton's method from afar leaps to and
  /// fro across them. Every step begins where the last two point.
  bool Follow(Path path, const SolveControl& control) {
    const int n = static_cast<int>(targets_.angle_sum.size());
    base_.assign(base_.size(), 0);
    if (path == Path::kNone) return true;
    Eigen::VectorXd missing(n), zero = Eigen::VectorXd::Zero(n), ahead = zero;
    if (!Energy().Gradient(zero.data(), missing.data())) return false;
    const int most_solves =
        std::clamp(kUnknownsOnPath / std::max(n, 1), kLeastSolvesOnPath, kMostSolvesOnPath);
    double done = 0, step = kFirstStepOnPath;
    if (path == Path::kLengths &&
        !Reach([&] { return At(path, 0, missing); }, kMostStepsToPath, control, &zero)) {
      return false;
    }
    for (int solves = 0; done < 1; ++solves) {
      if (solves == most_solves) return false;
      const double next = std::min(1.0, done + step);
      Eigen::VectorXd moved = (next - done) * ahead;
      const bool reached =
          Reach([&] { return At(path, next, missing); }, kMostStepsOnPath, control, &moved);
      if (reached) ahead = moved / (next - done);
      if (reached) done = next;
      step *= reached ? 2 : 0.25;
      if (step < kLeastStepOnPath) return false;
    }
    return true;
  }

  /// Minimises what `problem` makes at base_, from u on, and moves base_ and u there; leaves both where
  /// they are short of that. u is counted anew, as in SolveInSmallParts, as long as that helps.
  template <class Problem>
  bool Reach(const Problem& problem, int most_steps, const SolveControl& control,
             Eigen::VectorXd* u) {
    const Scales start = base_;
    SolverLimits limits{most_steps, kNearResidual};
    Eigen::VectorXd step = *u, moved = Eigen::VectorXd::Zero(u->size());
    double least = std::numeric_limits<double>::infinity();
    for (int idle = 0; idle < kIdlePartsOnPath;) {
      const ConformalEquivalenceEnergy energy = problem();
      const SolveSummary solve = MinimizeRobustly(energy, limits, control, &step);
      if (solve.termination == Termination::kCancelled) break;
      Advance(energy.ScaleOfVertices(step.data()), &base_);
      moved += step;
      if (solve.final_gradient_max <= kNearResidual) {
        *u = moved;
        return true;
      }
      if (solve.num_iterations() == 0) break;
      idle = solve.final_gradient_max < kLessResidual * least ? 0 : idle + 1;
      least = std::min(least, solve.final_gradient_max);
      limits.max_iterations = kIterationsInPart;
      step.setZero();
    }
    base_ = start;
    return false;
  }

  /// Beside edges that are not flipped triangles may be degenerate.
  Status CheckTriangles() const {
    const double* angle = result_.angles.value.data();
    for (Index h = 0; h < t_.num_halfedges(); ++h) {
      if (angle[h] > 0) continue;
      return Status(StatusCode::kNotConverged,
                    fmt::format("log scales: with the edges that are kept face {} (0-based) of the "
                                "flipped triangulation has an angle of 0",
                                Triangulation::Face(h)));
    }
    return Status();
  }

  /// The flat metric on a triangulation flipped from the start to where it is Delaunay for the scales
  /// base_: that has as few flips as need be, and depends on nothing that the solve went through.
  bool TakeAnew() {
    PtolemyComplex complex(start_.triangulation, log_lengths_, base_);
    Eigen::VectorXd& scale = result_.log_scale;
    scale.resize(t_.num_vertices);
    for (Index v = 0; v < t_.num_vertices; ++v) scale[v] = base_[v].Value();
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(t_.num_vertices);
    if (flips_ == Flips::kPtolemy && !complex.MakeDelaunay(none)) return false;
    result_.angles.value.resize(t_.num_halfedges());
    std::vector<double> rounding(t_.num_halfedges()), beyond(t_.num_halfedges());
    Eigen::VectorXd range(complex.num_faces());
    const double size =
        1 + log_lengths_.lpNorm<Eigen::Infinity>() + scale.lpNorm<Eigen::Infinity>();
    ParallelFor(complex.num_faces(), [&](Index f) {
      const LogTriangle triangle = complex.ScaledTriangle(f, none);
      range[f] = RangeOfSides(complex, f, none);
      double cotangents = 0;
      for (int k = 0; k < 3; ++k) cotangents += std::abs(triangle.Cotangent(k));
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        result_.angles.value[h] = triangle.angle[h - 3 * f];
        rounding[h] = cotangents * kRounding * size;
        beyond[h] = std::min(kPi, std::exp(range[f]) * kExtendedRounding * size);
      }
    });
    MeasureResidual(complex, rounding);
    beyond_digits_ = LargestSum(complex, beyond);
    longest_needle_ = range.maxCoeff();
    TakeTriangulation(complex);
    return true;
  }

  /// Of the logarithms of a face's sides, scaled by u.
  static double RangeOfSides(const PtolemyComplex& complex, Index f, const Eigen::VectorXd& u) {
    Eigen::Array3d x;
    for (int k = 0; k < 3; ++k) x[k] = complex.ScaledLogLength(3 * f + k, u);
    return x.maxCoeff() - x.minCoeff();
  }

  /// Of values at corners, over the vertices whose angle sums are prescribed.
  double LargestSum(const PtolemyComplex& complex, const std::vector<double>& at_corner) const {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(targets_.angle_sum.size());
    for (Index h = 0; h < t_.num_halfedges(); ++h) {
      const int p = targets_.parameter[complex.vertex(h)];
      if (p != kNone) sum[p] += at_corner[h];
    }
    return sum.size() > 0 ? sum.lpNorm<Eigen::Infinity>() : 0;
  }

  /// And what rounding of the lengths' logarithms may do to it: d alpha_i = sum of cotangents times
  /// changes of these.
  void MeasureResidual(const PtolemyComplex& complex, const std::vector<double>& rounding) {
    Eigen::VectorXd missed = targets_.angle_sum;
    for (Index h = 0; h < t_.num_halfedges(); ++h) {
      const int p = targets_.parameter[complex.vertex(h)];
      if (p != kNone) missed[p] -= result_.angles.value[h];
    }
    result_.residual = missed.size() > 0 ? missed.lpNorm<Eigen::Infinity>() : 0;
    rounding_ = LargestSum(complex, rounding);
  }

  void TakeTriangulation(const PtolemyComplex& complex) {
    IntrinsicTriangulation& intrinsic = result_.intrinsic;
    intrinsic.triangulation = complex.MakeTriangulation(t_.num_vertices);
    const Triangulation& flipped = intrinsic.triangulation;
    result_.log_lengths = complex.MakeLogLengths(flipped);
    result_.extended_log_lengths = complex.MakeExtendedLogLengths(flipped);
    intrinsic.lengths.value.resize(flipped.num_edges());
    for (Index e = 0; e < flipped.num_edges(); ++e) {
      const Index h = flipped.edge_halfedge[e];
      const double scale = result_.log_scale[flipped.Tail(h)] + result_.log_scale[flipped.Tip(h)];
      intrinsic.lengths.value[e] = std::exp(result_.log_lengths[e] - 0.5 * scale);
    }
    intrinsic.flips = start_.flips;
    result_.euclidean_flips = static_cast<int>(start_.flips.size());
    intrinsic.flips.insert(intrinsic.flips.end(), complex.flips().begin(), complex.flips().end());
    std::vector<Index> still(start_.triangulation.num_edges(), kNone);
    for (Index h = 0; h < complex.num_halfedges(); ++h) {
      if (complex.label(h) != kNone) still[complex.label(h)] = intrinsic.triangulation.edge[h];
    }
    intrinsic.edge_of_input = start_.edge_of_input;
    for (Index& e : intrinsic.edge_of_input) e = e == kNone ? kNone : still[e];
  }

  const Triangulation& t_;
  const Flips flips_;
  const IntrinsicTriangulation start_;
  const ScaleTargets targets_;
  Eigen::VectorXd log_lengths_;
  Scales base_;                ///< of the vertices, from which the solves count u
  double rounding_ = 0;        ///< [rad], of the angle sums, by a double's digits
  double beyond_digits_ = 0;   ///< [rad], likewise by those that lengths have
  double longest_needle_ = 0;  ///< largest range of a face's sides' logarithms
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

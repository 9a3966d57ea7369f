#include "cirque/pipeline/refine_boundary.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "cirque/cones/log_scale_norm.h"
#include "cirque/core/triangulation.h"
#include "cirque/cuts/cut_graph.h"
#include "cirque/energy/angle_objective.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"
#include "cirque/layout/planar_layout.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/cone_stages.h"
#include "cirque/pipeline/flatten.h"

namespace cirque {
namespace {

constexpr double kArmijo = 1e-4;
constexpr int kMostHalvings = 6;
constexpr double kLeastDecrease = 1e-3;  ///< of the norm to the p, after which another step follows
constexpr double kFlat = 1e-9;           ///< a norm of log scales that is rounding
constexpr double kShares[] = {0.5, 0.25, 0.125, 0};  ///< of the way from the isometric boundary

/// A boundary that was solved for.
struct Solved {
  Eigen::VectorXd angle_sums;
  ConeTargets targets;
  FlatSurface flat;
  Certificate certificate;
  double value;  ///< LogScaleNorm
};

class BoundaryRefinement {
 public:
  BoundaryRefinement(const FlattenJob& job, const BoundaryDescent& descent,
                     const BoundaryProblem& problem, const AngleObjective& objective, Solved start)
      : job_(job),
        descent_(descent),
        problem_(problem),
        objective_(objective),
        is_disk_(IsFlatDisk(job)),
        now_(std::move(start)) {
    now_.value = LogScaleNorm(now_.flat, descent.power);
  }

  void Run(const PredictedBoundary& predicted) {
    const double before = now_.value;
    if (!Overlaps(now_.flat) || StepBack(predicted)) Descend();
    BoundarySummary& summary = Fill(&now_.certificate.boundary);
    summary.boundary_steps = steps_;
    summary.boundary_solves = solves_;
    summary.boundary_overlaps_avoided = avoided_;
    summary.boundary_log_scale_before = Norm(before);
    summary.boundary_log_scale_after = Norm(now_.value);
  }

  Solved& now() { return now_; }

 private:
  static bool IsFlatDisk(const FlattenJob& job) {
    const Triangulation& t = job.surface.triangulation;
    return BoundaryLoops(t).size() == 1 && EulerCharacteristic(t) == 1 &&
           ConeVertices(job.surface.boundary, job.targets).empty();
  }

  double Norm(double value) const { return std::pow(descent_.power * value, 1.0 / descent_.power); }

  bool Overlaps(const FlatSurface& flat) const {
    if (!is_disk_) return false;
    const Triangulation& t = job_.surface.triangulation;
    const PlanarLayout layout = LayOutByDirections(t, flat.on_input.angles, flat.on_input.lengths);
    // What the input's triangles would have flipped is not laid out yet, and cannot be judged.
    return FlippedFaces(t, layout.uv).empty() && OverlapsItself(t, layout.uv);
  }

  /// False where even the isometric boundary's image overlaps itself, or has no coherent angles.
  bool StepBack(const PredictedBoundary& predicted) {
    ++avoided_;
    for (const double share : kShares) {
      const Eigen::VectorXd sums =
          predicted.isometric + share * (predicted.angle_sums - predicted.isometric);
      Solved trial;
      if (!Solve(sums, &trial) || Overlaps(trial.flat)) continue;
      now_ = std::move(trial);
      return true;
    }
    return false;
  }

  void Descend() {
    // A surface that is flat as it is keeps its angles, whose derivatives may not exist: four points
    // of its triangles on one circle have theta = 0.
    if (Norm(now_.value) < kFlat) return;
    while (steps_ < descent_.steps) {
      const double before = now_.value;
      if (!Step()) return;
      ++steps_;
      if (now_.value > (1 - kLeastDecrease) * before) return;
    }
  }

  bool Step() {
    const FlatSurface& flat = now_.flat;
    const IntrinsicSurface solved =
        MeasureSurface(flat.intrinsic.triangulation, flat.intrinsic.lengths);
    const Eigen::VectorXd gradient = LogScaleNormGradient(
        flat, TransferTargets(job_.surface, now_.targets, solved), objective_, descent_.power);
    const Eigen::VectorXd step = LogScaleStep(problem_, descent_.power, descent_.filter,
                                              VertexLogScale(flat), Turning(gradient));
    const Eigen::VectorXd change = Turning(step);
    const double slope = gradient.dot(change);
    if (!(slope < 0)) return false;
    double length = 1;
    for (int i = 0; i <= kMostHalvings; ++i, length /= 2) {
      Solved trial;
      if (!Solve(now_.angle_sums + length * change, &trial)) continue;
      if (!(trial.value <= now_.value + kArmijo * length * slope)) continue;
      if (Overlaps(trial.flat)) {
        ++avoided_;
        continue;
      }
      now_ = std::move(trial);
      return true;
    }
    return false;
  }

  /// What angle sums at the boundary change by with log scales there: symmetric, so that it also
  /// takes gradients by angle sums to those by log scales.
  Eigen::VectorXd Turning(const Eigen::VectorXd& b) const {
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(b.size());
    Eigen::VectorXd turning = problem_.AngleSums(problem_.Harmonic(b)) - problem_.AngleSums(none);
    for (Eigen::Index v = 0; v < turning.size(); ++v) {
      if (!problem_.IsOpen(static_cast<Index>(v))) turning[v] = 0;
    }
    return turning;
  }

  bool Solve(const Eigen::VectorXd& sums, Solved* solved) {
    if (job_.control.cancelled && *job_.control.cancelled) return false;
    const StatusOr<Eigen::VectorXd> fitting = problem_.FitToGaussBonnet(sums);
    if (!fitting.ok()) return false;
    ++solves_;
    solved->angle_sums = *fitting;
    solved->targets = job_.targets;
    for (const Index v : problem_.boundary()) {
      solved->targets.lower[v] = solved->targets.upper[v] = solved->angle_sums[v];
    }
    solved->certificate = now_.certificate;
    const FlattenJob job = {job_.surface, solved->targets, job_.options,
                            job_.control, job_.locked,     job_.rotations};
    if (!Flatten(job, &solved->certificate, &solved->flat).ok()) return false;
    solved->value = LogScaleNorm(solved->flat, descent_.power);
    return true;
  }

  const FlattenJob& job_;
  const BoundaryDescent& descent_;
  const BoundaryProblem& problem_;
  const AngleObjective& objective_;
  const bool is_disk_;
  Solved now_;
  int steps_ = 0, solves_ = 0, avoided_ = 0;
};

}  // namespace

Status RefineBoundary(const FlattenJob& job, const BoundaryDescent& descent,
                      const BoundaryProblem& problem, const PredictedBoundary& predicted,
                      Certificate* certificate, ConeTargets* targets, FlatSurface* flat) {
  const auto objective = AngleObjectiveOf(job.options);
  if (!objective.ok()) return objective.status();
  BoundaryRefinement refinement(
      job, descent, problem, **objective,
      {predicted.angle_sums, *targets, std::move(*flat), std::move(*certificate), 0});
  refinement.Run(predicted);
  Solved& solved = refinement.now();
  *targets = std::move(solved.targets);
  *flat = std::move(solved.flat);
  *certificate = std::move(solved.certificate);
  if (job.control.cancelled && *job.control.cancelled)
    return Status(StatusCode::kCancelled, "refinement of the boundary: interrupted");
  return Status();
}

}  // namespace cirque

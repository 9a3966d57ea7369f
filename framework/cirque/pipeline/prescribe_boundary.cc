#include "cirque/pipeline/prescribe_boundary.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "cirque/cones/boundaries.h"
#include "cirque/cones/boundary_problem.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"
#include "cirque/pipeline/refine_boundary.h"

namespace cirque {
namespace {

constexpr double kRanges[] = {0, 0.05, 0.2, 0.5};  ///< [rad]: about the predicted angle sums

/// The angle sums of a boundary with what the linear model predicts of them.
struct Prediction {
  Eigen::VectorXd angle_sums;
  std::vector<BoundaryProblem::Bounds> bounds;  ///< V, of boundary vertices
  BoundarySummary summary;
  BoundaryDescent descent;
};

/// The problem of a surface, on its intrinsic Delaunay connectivity.
class DelaunayProblem {
 public:
  DelaunayProblem(const FlattenJob& job, const FileVertices& file)
      : delaunay_(MakeIntrinsicDelaunay(job.surface.triangulation, job.surface.lengths)),
        problem_(MeasureSurface(delaunay_.triangulation, delaunay_.lengths), job.surface,
                 job.targets, file) {}

  BoundaryProblem& operator*() { return problem_; }

 private:
  const IntrinsicTriangulation delaunay_;
  BoundaryProblem problem_;
};

void Summarize(const BoundaryProblem& problem, const Eigen::VectorXd& angle_sums,
               BoundarySummary* summary) {
  summary->boundary_vertices = static_cast<int>(problem.boundary().size());
  for (const Index v : problem.boundary()) {
    const auto [lower, upper] = problem.BoundsOf(v);
    if (angle_sums[v] <= lower || angle_sums[v] >= upper) ++summary->boundary_at_bounds;
  }
}

StatusOr<Prediction> Predict(const FlattenJob& job, BoundaryProblem* problem) {
  const auto shape = ParseBoundaryShape(job.options.boundary);
  if (!shape.ok()) return shape.status();
  StatusOr<Eigen::VectorXd> sums = (*shape)->Choose(problem);
  if (!sums.ok()) return sums.status().In("boundary");
  Prediction prediction{*std::move(sums), {}, {}, (*shape)->descent()};
  for (Index v = 0; v < job.surface.triangulation.num_vertices; ++v) {
    prediction.bounds.push_back(problem->BoundsOf(v));
  }
  Summarize(*problem, prediction.angle_sums, &prediction.summary);
  return prediction;
}

/// RefineBoundary, from a surface that was flattened with the predicted boundary.
Status Descend(const FlattenJob& job, const FileVertices& file, const Prediction& prediction,
               const BoundaryProblem& problem, Certificate* certificate, ConeTargets* targets,
               FlatSurface* flat) {
  DelaunayProblem anew(job, file);
  const StatusOr<Eigen::VectorXd> isometric = (*ParseBoundaryShape("isometric"))->Choose(&*anew);
  if (!isometric.ok()) return Status();
  return RefineBoundary(job, prediction.descent, problem, {prediction.angle_sums, *isometric},
                        certificate, targets, flat);
}

/// The targets with the boundary's angle sums within that range about the predicted ones.
ConeTargets WithBoundary(const IntrinsicSurface& surface, const Prediction& prediction,
                         double range, ConeTargets targets) {
  for (Index v = 0; v < surface.triangulation.num_vertices; ++v) {
    if (!surface.boundary[v]) continue;
    const double sum = prediction.angle_sums[v];
    const auto [lower, upper] = prediction.bounds[v];
    targets.lower[v] = std::max(sum - range, std::min(sum, lower));
    targets.upper[v] = std::min(sum + range, std::max(sum, upper));
  }
  return targets;
}

bool MayHoldWithMoreRange(const Status& status) {
  return status.code() == StatusCode::kInfeasible || status.code() == StatusCode::kNotConverged;
}

bool IsClosed(const IntrinsicSurface& surface) {
  return std::find(surface.boundary.begin(), surface.boundary.end(), true) ==
         surface.boundary.end();
}

}  // namespace

bool AsksForBoundary(const IntrinsicSurface& surface, const ParameterizeOptions& options) {
  if (options.boundary == kFreeBoundary) return false;
  return options.seams != SeamKind::kFree || !IsClosed(surface);
}

bool HasFreeBoundary(const IntrinsicSurface& surface, const ConeTargets& targets) {
  for (Index v = 0; v < surface.triangulation.num_vertices; ++v) {
    const bool free = targets.lower[v] <= 0 && targets.upper[v] >= kPi * surface.corners[v];
    if (surface.boundary[v] && !free) return false;
  }
  return true;
}

Status FlattenWithBoundary(const FlattenJob& job, const FileVertices& file,
                           const FlattenMethod& flatten, Certificate* certificate,
                           ConeTargets* targets, FlatSurface* flat) {
  if (IsClosed(job.surface)) {
    return Status::InvalidInput(
        "boundary: the surface is closed and has none; open it along a cut, or with free seams");
  }
  DelaunayProblem problem(job, file);
  const StatusOr<Prediction> prediction = Predict(job, &*problem);
  if (!prediction.ok()) return prediction.status();
  Status first;
  for (const double range : kRanges) {
    ConeTargets ranged = WithBoundary(job.surface, *prediction, range, job.targets);
    const Status status =
        flatten({job.surface, ranged, job.options, job.control, job.locked}, certificate, flat);
    BoundarySummary& summary = Fill(&certificate->boundary);
    summary = prediction->summary;
    summary.boundary_range = range;
    if (range == 0) first = status;
    if (status.ok()) *targets = std::move(ranged);
    if (status.ok() && range == 0 && prediction->descent.steps > 0) {
      return Descend(job, file, *prediction, *problem, certificate, targets, flat);
    }
    if (job.options.strict || !MayHoldWithMoreRange(status)) return status;
  }
  return first;
}

}  // namespace cirque

#include "cirque/pipeline/make_injective.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cirque/cones/turning_program.h"
#include "cirque/core/solve_summary.h"
#include "cirque/cuts/charts.h"
#include "cirque/layout/packing.h"
#include "cirque/math/compensated_sum.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/cut_costs.h"
#include "cirque/pipeline/descend.h"
#include "cirque/pipeline/finish_layout.h"
#include "cirque/pipeline/prescribe_boundary.h"

namespace cirque {
namespace {

using Job = ParameterizeJob;

constexpr double kLeastAngle = 0.2 * kPi, kGreatestAngle = 1.75 * kPi;
constexpr double kShare = 0.8;      ///< of what there is, of what the corners can reach
constexpr double kSafe = 0.95;      ///< of pi that an arc may turn back by, and be a solve's
constexpr double kSmallest = 1e-3;  ///< of the boundary's mean length, of a corner's
constexpr int kMostPackings = 4;    ///< whose rounding made charts overlap

constexpr char kNoBoundary[] = "no such boundary";
constexpr char kDistorted[] = "injective, but charts are less distorted by far";
/// How much worse than the flat metric, which charts keep, an image by descent may be: so many times,
/// and so much beside that in the mean of q and in the L2 norm of the log area ratio.
constexpr double kMostTimes = 2, kMostAngles = 0.1, kMostAreas = 0.5;

/// The boundary of an image's one patch, corner by corner.
struct ImageBoundary {
  std::vector<Index> vertex;  ///< of the surface
  std::vector<bool> free;     ///< whether the corner is all of its vertex and no seam's
  TurningProgram program;     ///< but for most_back
};

/// The angle sums of the flat surface's vertices.
std::vector<double> FlatAngleSums(const Job& job, const Parameterization& map) {
  return VertexAngleSums(job.surface.triangulation, map.flat.on_input.angles);
}

/// Nothing where the image has several patches or loops.
std::optional<ImageBoundary> BoundaryOf(const Job& job, const Parameterization& map) {
  const Triangulation& t = job.surface.triangulation;
  const Triangulation open = CutOpen(t, map.cut);
  const std::vector<std::vector<Index>> loops = BoundaryLoops(open);
  if (loops.size() != 1) return std::nullopt;
  const std::vector<Index>& loop = loops.front();
  const InputChart& flat = map.flat.on_input;
  const std::vector<double> sum = VertexAngleSums(open, flat.angles);
  const std::vector<Index> solved = CornersPerVertex(map.flat.intrinsic.triangulation);
  std::vector<int> fans(t.num_vertices, 0);
  for (const Index h : loop) ++fans[t.Tail(h)];
  const auto n = static_cast<Index>(loop.size());
  ImageBoundary boundary;
  TurningProgram& program = boundary.program;
  program.turning.resize(n), program.lower.resize(n), program.upper.resize(n);
  program.weight = Eigen::VectorXd::Zero(n);
  double mean = 0;
  for (const Index h : loop) mean += flat.lengths.value[t.edge[h]] / n;
  for (Index k = 0; k < n; ++k) {
    const Index h = loop[k], before = loop[(k + n - 1) % n], v = t.Tail(h);
    const double now = sum[open.Tail(h)];
    const double reach = kShare * kPi * std::min(job.surface.corners[v], solved[v]);
    boundary.vertex.push_back(v);
    boundary.free.push_back(job.surface.boundary[v] && fans[v] == 1);
    program.turning[k] = kPi - now;
    program.lower[k] = kPi - std::max(now, std::min(kGreatestAngle, reach));
    program.upper[k] = kPi - std::min(kLeastAngle, kShare * now);
    if (!boundary.free.back()) continue;
    const double length =
        0.5 * (flat.lengths.value[t.edge[h]] + flat.lengths.value[t.edge[before]]);
    program.weight[k] = mean / std::max(length, kSmallest * mean);
  }
  return boundary;
}

/// The targets with the boundary's angle sums as they are, but at free corners turning so; exact
/// by Gauss-Bonnet.
ConeTargets TargetsFor(const Job& job, const Parameterization& map, const ImageBoundary& boundary,
                       const Eigen::VectorXd& turning) {
  const Triangulation& t = job.surface.triangulation;
  const std::vector<double> sum = FlatAngleSums(job, map);
  ConeTargets targets = map.targets;
  std::vector<Index> free;
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (job.surface.boundary[v]) targets.lower[v] = targets.upper[v] = sum[v];
  }
  for (std::size_t k = 0; k < boundary.vertex.size(); ++k) {
    const Index v = boundary.vertex[k];
    if (!boundary.free[k]) continue;
    targets.lower[v] = targets.upper[v] = kPi - turning[static_cast<Index>(k)];
    free.push_back(v);
  }
  CompensatedSum missing;
  missing += kPi * t.num_faces();
  for (Index v = 0; v < t.num_vertices; ++v) {
    missing -= targets.IsFixed(v) ? targets.lower[v] : sum[v];
  }
  for (const Index v : free) {
    targets.lower[v] = targets.upper[v] += missing.Value() / static_cast<double>(free.size());
  }
  return targets;
}

/// Whether the two sides of a seam must match, or the rotations across it.
bool KeepsSeams(const Job& job) {
  const ParameterizeOptions& options = job.options;
  return options.seams == SeamKind::kRigid || options.holonomy != HolonomyRule::kFree ||
         options.integer_cells > 0 || job.rotations || job.targets_given ||
         options.cone_angles != "free" || options.cones.starts_with("given");
}

bool Overlaps(const Job& job, const Parameterization& map) {
  return OverlapsItself(CutOpen(job.surface.triangulation, map.cut), map.uv);
}

/// One image on its way to being injective.
class Remedy {
 public:
  Remedy(const Job& job, const FlattenJobToTargets& flatten, Parameterization* result)
      : job_(job), flatten_(flatten), result_(*result) {}

  Status Run() {
    if (!Overlaps(job_, result_)) return Status();
    job_.control.BeginStage("injectivity");
    if (MayTurnBoundary()) {
      if (Status s = TurnBoundary(); !s.ok()) return s;
    }
    if (summary_.made_by.empty() && MayDescend()) {
      const Timer timer;
      if (Status s = Descend(); !s.ok()) return s;
      AddSeconds(timer, &result_.certificate.seconds.injective);
    }
    if (summary_.made_by.empty()) {
      const Timer timer;
      if (Status s = CutIntoCharts(); !s.ok()) return s;
      AddSeconds(timer, &result_.certificate.seconds.injective);
    }
    summary_.injectivity_stages = static_cast<int>(summary_.tried.size());
    result_.certificate.injectivity = std::move(summary_);
    return Status();
  }

 private:
  bool MayTurnBoundary() const {
    return AsksForBoundary(job_.surface, job_.options) ||
           (HasFreeBoundary(job_.surface, result_.targets) && HasBoundary());
  }

  bool HasBoundary() const {
    const auto& boundary = job_.surface.boundary;
    return std::find(boundary.begin(), boundary.end(), true) != boundary.end();
  }

  void Note(const char* stage, const std::string& outcome, const Timer& timer) {
    summary_.tried.push_back({stage, outcome, "", timer.Seconds()});
    if (outcome == kInjective) summary_.made_by = stage;
  }

  /// Error: cancelled.
  Status TurnBoundary() {
    const auto first = BoundaryOf(job_, result_);
    if (!first) return Status();
    const double excess = -DeepestArc(first->program.turning).turning - kPi;
    Parameterization last = result_;
    for (const double most_back : {kPi + 0.5 * excess, kSafe * kPi, 0.5 * kPi, (1 - kSafe) * kPi}) {
      if (most_back > kPi && excess <= 0) continue;
      const Timer timer;
      Parameterization next;
      std::string outcome;
      const Status status = Turn(*first, most_back, last, &next, &outcome);
      Note("curvature", outcome, timer);
      if (status.code() == StatusCode::kCancelled) return status;
      if (outcome == kInjective) {
        Accept(*first, std::move(next));
        return Status();
      }
      if (outcome == kNoBoundary) return Status();  // nor one that turns back less
      if (status.ok() && outcome == kOverlaps) last = std::move(next);
    }
    return Status();
  }

  /// Flattens and lays out with the boundary of the first image turned so that no arc of that of the
  /// last image turns back farther.
  Status Turn(const ImageBoundary& first, double most_back, const Parameterization& last,
              Parameterization* next, std::string* outcome) {
    *outcome = kNoBoundary;
    std::optional<ImageBoundary> boundary = BoundaryOf(job_, last);
    if (!boundary) return Status();
    // Seams may have moved; what is chosen stays near what it was at first.
    if (boundary->vertex == first.vertex) {
      for (Index k = 0; k < first.program.turning.size(); ++k) {
        if (first.free[k]) boundary->program.turning[k] = first.program.turning[k];
      }
    }
    boundary->program.most_back = most_back;
    const auto turning = LeastTurning(boundary->program);
    if (!turning) return Status();
    next->targets = TargetsFor(job_, last, *boundary, *turning);
    next->certificate = last.certificate;
    Status status = flatten_(job_, next);
    if (status.ok()) status = CutAndPlace(job_, next);
    *outcome = ToString(status.code());
    if (status.ok()) *outcome = Overlaps(job_, *next) ? kOverlaps : kInjective;
    return status;
  }

  void Accept(const ImageBoundary& first, Parameterization next) {
    double turned = 0;
    for (std::size_t k = 0; k < first.vertex.size(); ++k) {
      if (!first.free[k]) continue;
      const double before = kPi - first.program.turning[static_cast<Index>(k)];
      turned = std::max(turned, std::abs(next.targets.lower[first.vertex[k]] - before));
    }
    summary_.boundary_turned = turned;
    result_ = std::move(next);
  }

  /// Where seams may part and the image is one disk.
  bool MayDescend() const {
    if (KeepsSeams(job_) || (HasBoundary() && !MayTurnBoundary())) return false;
    const Triangulation open = CutOpen(job_.surface.triangulation, result_.cut);
    return result_.flat.on_input.flipped.empty() && ConnectedPatches(open).count == 1 &&
           EulerCharacteristic(open) == 1 && BoundaryLoops(open).size() == 1;
  }

  /// Error: cancelled.
  Status Descend() {
    const Timer timer;
    StatusOr<Descent> descent =
        DescendToInjective(job_.surface, result_.flat.on_input.lengths, result_.cut,
                           job_.options.refine_map, job_.control.cancelled);
    if (descent.status().code() == StatusCode::kCancelled) return descent.status();
    std::string outcome = ToString(descent.status().code());
    if (descent.ok()) outcome = Judge(descent->uv);
    Note("descent", outcome, timer);
    if (outcome != kInjective) return Status();
    result_.uv = std::move(descent->uv);
    summary_.descent_steps = descent->steps;
    summary_.descent_before = descent->before, summary_.descent_after = descent->after;
    if (descent->refinement) result_.certificate.map_refinement = descent->refinement;
    DescribeCut(job_, &result_);
    result_.certificate.seams = SeamSummary();  // none, as where seams are free from the first
    return Status();
  }

  /// The outcome of an image that descent ended at, of which charts are the alternative.
  std::string Judge(const CornerUv& uv) const {
    const Triangulation& t = job_.surface.triangulation;
    if (!FlippedFaces(t, uv).empty() || OverlapsItself(CutOpen(t, result_.cut), uv)) {
      return kOverlaps;
    }
    const EdgeLengths& lengths = job_.surface.lengths;
    const DistortionSummary flat = DistortionOf(t, lengths, result_.uv);
    const DistortionSummary now = DistortionOf(t, lengths, uv);
    const bool angles =
        now.quasi_conformal_mean - 1 <= kMostTimes * (flat.quasi_conformal_mean - 1) + kMostAngles;
    const bool areas = now.log_area_ratio_l2 <= kMostTimes * flat.log_area_ratio_l2 + kMostAreas;
    return LeavesConformal(job_.options.refine_map) || (angles && areas) ? kInjective : kDistorted;
  }

  /// Error: cancelled.
  Status CutIntoCharts() {
    const Timer timer;
    const Triangulation& t = job_.surface.triangulation;
    for (int packing = 0; packing < kMostPackings && Overlaps(job_, result_); ++packing) {
      StatusOr<Cut> cut =
          cirque::CutIntoCharts({t, result_.cut, result_.uv, job_.inside}, job_.control.cancelled);
      if (!cut.ok()) return cut.status();
      result_.cut = *std::move(cut);
      const Patches charts = ConnectedPatches(CutOpen(t, result_.cut));
      summary_.charts = static_cast<int>(charts.count);
      PackingOptions options;
      options.rotate = packing == 0;
      result_.uv = PackPatches(result_.uv, charts, options).uv;
    }
    const bool flipped = !FlippedFaces(t, result_.uv).empty();
    Note("charts", flipped || Overlaps(job_, result_) ? kOverlaps : kInjective, timer);
    DescribeCut(job_, &result_);
    if (!flipped) return Status();
    return Status(StatusCode::kUnrepresentable,
                  "the image's charts exist but doubles cannot hold them side by side");
  }

  const Job& job_;
  const FlattenJobToTargets& flatten_;
  Parameterization& result_;
  InjectivitySummary summary_;
};

}  // namespace

Status MakeInjective(const Job& job, const FlattenJobToTargets& flatten, Parameterization* result) {
  return Remedy(job, flatten, result).Run();
}

}  // namespace cirque

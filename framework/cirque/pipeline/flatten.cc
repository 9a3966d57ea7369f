#include "cirque/pipeline/flatten.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cirque/angles/infeasibility.h"
#include "cirque/core/count.h"
#include "cirque/core/solve_summary.h"
#include "cirque/intrinsic/metric_delaunay.h"
#include "cirque/math/compensated_sum.h"
#include "cirque/math/elementary.h"
#include "cirque/pipeline/flat_metric.h"
#include "cirque/pipeline/retriangulate.h"
#include "cirque/pipeline/solve_flat_metric.h"
#include "cirque/pipeline/untangle_chart.h"
#include "cirque/radii/solve_log_radii.h"

namespace cirque {
namespace {

constexpr double kKeptShare = 1.0 / 15;  ///< of the mesh's extent, round what came out flipped

/// The faces and all that can be reached from them over that many edges.
std::vector<bool> Neighbourhood(const Triangulation& t, std::vector<Index> faces, int edges) {
  std::vector<bool> inside(t.num_faces(), false);
  for (const Index f : faces) inside[f] = true;
  for (int ring = 0; ring < edges; ++ring) {
    std::vector<Index> reached;
    for (const Index f : faces) {
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        if (t.twin[h] == kNone || inside[Triangulation::Face(t.twin[h])]) continue;
        inside[Triangulation::Face(t.twin[h])] = true;
        reached.push_back(Triangulation::Face(t.twin[h]));
      }
    }
    faces = std::move(reached);
  }
  return inside;
}

/// Why the input's own triangulation was solved on, and what else there is: `on_input` alone would
/// say that nothing is known.
Status AfterFlips(const std::vector<Index>& flipped, const Status& on_input) {
  return {on_input.code(),
          fmt::format("the circle pattern on the intrinsic Delaunay triangulation would flip {} of "
                      "the input (--exact=OUT writes its map), and on the input's own triangles {}",
                      Count(flipped.size(), "triangle"), on_input.message())};
}

/// One surface on its way to a flat metric.
class Flattening {
 public:
  Flattening(const FlattenJob& job, Certificate* certificate, FlatSurface* result)
      : job_(job),
        input_(job.surface.triangulation),
        targets_(job.targets),
        options_(job.options),
        certificate_(*certificate),
        flips_(Fill(&certificate->triangulation)),
        result_(*result),
        source_area_(SurfaceArea(job.surface)) {}

  Status Run() {
    result_.exact.reset();
    if (Status s = CheckTargets(job_.surface, targets_, &result_.infeasibility); !s.ok()) return s;
    if (options_.triangulation == SolvedTriangulation::kInput) return SolveAsAsked();
    if (job_.dual == DualFit::kWandered && SolverIsFree() && InteriorPointIsCheap(input_)) {
      const Status status = SolveOnInput(FitStart::kAfterWandering);
      if (status.code() != StatusCode::kNotConverged) return status;
    }
    std::vector<bool> locked(input_.num_edges(), false);
    if (job_.locked) locked = *job_.locked;
    flips_.delaunay_rounds = 0;
    const auto flipped = SolveLockingFlipped(
        std::move(locked), [&](const std::vector<bool>& edges) { return SolveRound(edges); },
        [&](const std::vector<Index>& faces, std::vector<bool>* edges) {
          Lock(faces, rounds_solved_++, edges);
          return true;
        });
    if (flipped.ok() && flipped->empty()) return Status();
    const bool may_do_better = flipped.ok() || MayDoBetterOnInput(flipped.status());
    if (!may_do_better || (!flipped.ok() && SolvedOnInput())) return flipped.status();
    const bool wandered = Wandered(flipped.status());
    if (wandered && job_.dual == DualFit::kOrNothing) return flipped.status();
    Status status = SolveOnInput(wandered ? FitStart::kAfterWandering : Begin());
    if (!MayDoBetterOnInput(status)) return status;
    if (first_) return TakeFirst();
    return flipped.ok() ? AfterFlips(*flipped, status) : status;
  }

 private:
  /// Keeps the edges of faces that came out flipped: those faces then are faces of the pattern.
  /// What is kept strains its surroundings, which may come out flipped next; from the second time
  /// on more and more of them is kept, until the border lies where little is to be flipped.
  void Lock(const std::vector<Index>& flipped, int round, std::vector<bool>* locked) const {
    const double extent = std::sqrt(input_.num_faces());  // of the mesh, in edges
    const int edges = static_cast<int>(round * kKeptShare * extent);
    const std::vector<bool> kept = Neighbourhood(input_, flipped, edges);
    for (Index h = 0; h < input_.num_halfedges(); ++h) {
      if (kept[Triangulation::Face(h)]) (*locked)[input_.edge[h]] = true;
    }
  }

  /// The exact map is that of the first round's metric, whatever its triangles on the input.
  Status TakeFirst() {
    result_ = std::move(first_->surface);
    certificate_.angle_fit = first_->angle_fit;
    certificate_.radii = first_->radii;
    flips_ = first_->flips;
    return Status();
  }

  static bool MayDoBetterOnInput(const Status& status) {
    return status.code() == StatusCode::kInfeasible || status.code() == StatusCode::kNotConverged;
  }

  /// Whether the solve from 0 that has ended was that of the input's own triangles already.
  bool SolvedOnInput() const {
    return result_.intrinsic.flips.empty() && rounds_solved_ == 0 && !has_start_;
  }

  /// Whether the dual found neither angles nor a proof: with angles it was the radii that failed.
  bool Wandered(const Status& status) const {
    return status.code() == StatusCode::kNotConverged && result_.multipliers.size() == 0 &&
           SolverIsFree();
  }

  bool SolverIsFree() const { return options_.angle_solver == ParameterizeOptions().angle_solver; }

  FitStart Begin() const {
    return rounds_solved_ > 0 || has_start_ ? FitStart::kMultipliers : FitStart::kZero;
  }

  StatusOr<std::vector<Index>> SolveRound(const std::vector<bool>& locked) {
    ++*flips_.delaunay_rounds;
    const Timer timer;
    job_.control.BeginStage("triangulation");
    result_.intrinsic =
        HasAngleSums(job_.surface, targets_)
            ? MakeDelaunayOfMetric(input_, job_.surface.lengths, locked)
            : MakeIntrinsicDelaunay(input_, job_.surface.lengths, {&targets_, locked});
    AddSeconds(timer, &certificate_.seconds.triangulation);
    if (Status s = FlipForTheFit(); !s.ok()) return s;
    if (Status s = Solve(Begin()); !s.ok()) return s;
    return result_.on_input.flipped;
  }

  /// Once: later rounds only lock edges.
  Status FlipForTheFit() {
    if (options_.retriangulate == 0 || rounds_solved_ > 0) return Status();
    const Timer timer;
    job_.control.BeginStage("retriangulation");
    Status status = Retriangulate(job_, &certificate_, &result_);
    has_start_ = true;
    AddSeconds(timer, &certificate_.seconds.triangulation);
    return status;
  }

  /// On the input's triangles because these were asked for.
  Status SolveAsAsked() {
    const Status status = SolveOnInput(Begin());
    if (status.code() != StatusCode::kInfeasible) return status;
    return {status.code(), status.message() + ", or flip to the intrinsic Delaunay triangulation"};
  }

  Status SolveOnInput(FitStart start) {
    result_.intrinsic = {input_, job_.surface.lengths, {}, {}};
    return Solve(start);
  }

  Status Solve(FitStart start) {
    flips_.flips = static_cast<int>(result_.intrinsic.flips.size());
    if (Status s = SolveFlatMetric(job_, start, &certificate_, &result_); !s.ok()) return s;
    const Timer timer;
    ReadBack();
    AddSeconds(timer, &certificate_.seconds.layout);
    return Status();
  }

  const Triangulation& t() const { return result_.intrinsic.triangulation; }

  void ReadBack() {
    const CornerAngles flat = FlatCornerAngles(t(), result_.angles, result_.log_radii);
    ScaleToSurfaceArea(flat);
    result_.intrinsic_lengths = FlatEdgeLengths(t(), flat, result_.log_radii);
    if (options_.exact && !result_.exact) {
      result_.exact = {result_.intrinsic, flat, result_.intrinsic_lengths};
    }
    if (result_.is_own) {
      // Undoing flips would bring no more than rounding, which turns needles over.
      result_.on_input = {job_.surface.angles, job_.surface.lengths, {}};
      return;
    }
    result_.on_input = ReadOnInput(input_, result_.intrinsic, flat, result_.intrinsic_lengths);
    UntangleChart(job_, VertexAngleSums(t(), flat), &flips_, &result_.on_input);
    if (options_.exact && !first_ && !result_.on_input.flipped.empty()) {
      first_ = {result_, certificate_.angle_fit, certificate_.radii, flips_};
    }
  }

  /// Shifts the gauge so that the image has the surface's area.
  void ScaleToSurfaceArea(const CornerAngles& flat) {
    if (!(source_area_ > 0)) return;  // needles alone, whose lengths are those of flat triangles
    const double image_area = ParallelSum(input_.num_faces(), [&](Index f) {
      const double radius = std::exp(result_.log_radii.value[f]);
      double image = 2 * radius * radius;
      for (Index h = 3 * f; h < 3 * f + 3; ++h) image *= SineToPi(flat.value[h]);
      return image;
    });
    result_.log_radii.value.array() += 0.5 * std::log(source_area_ / image_area);
  }

  /// A round, and what the certificate said of it.
  struct Round {
    FlatSurface surface;
    std::optional<AngleFitSummary> angle_fit;
    std::optional<RadiiSummary> radii;
    TriangulationSummary flips;
  };

  const FlattenJob& job_;
  const Triangulation& input_;
  const ConeTargets& targets_;
  const ParameterizeOptions& options_;
  Certificate& certificate_;
  TriangulationSummary& flips_;
  FlatSurface& result_;
  const double source_area_;
  int rounds_solved_ = 0;       ///< of the lazily constrained loop
  bool has_start_ = false;      ///< multipliers near the solution's
  std::optional<Round> first_;  ///< where there is an exact map of it only
};

}  // namespace

StatusOr<std::vector<Index>> SolveLockingFlipped(std::vector<bool> locked,
                                                 const SolveWithLocked& solve,
                                                 const LockFlipped& lock) {
  StatusOr<std::vector<Index>> flipped = solve(locked);
  for (int round = 1; round < kMostLockingRounds; ++round) {
    if (!flipped.ok() || flipped->empty() || !lock(*flipped, &locked)) break;
    flipped = solve(locked);
  }
  return flipped;
}

Status Flatten(const FlattenJob& job, Certificate* certificate, FlatSurface* result) {
  return Flattening(job, certificate, result).Run();
}

}  // namespace cirque

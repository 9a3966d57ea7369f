#include "cirque/pipeline/retriangulate.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "cirque/angles/angle_fit.h"
#include "cirque/angles/registry.h"
#include "cirque/energy/angle_objective.h"
#include "cirque/intrinsic/flip_complex.h"
#include "cirque/intrinsic/flip_edges.h"
#include "cirque/intrinsic/intrinsic_surface.h"

namespace cirque {
namespace {

constexpr double kActive = 1e-6;         ///< [rad]: a theta so near to its bound is at it
constexpr double kLeastDecrease = 1e-7;  ///< relative, of a round that is kept

/// An angle fit on one triangulation.
struct Fit {
  IntrinsicTriangulation on;
  AngleFitResult result;
  Status status;
  std::vector<Index> named;  ///< edges that ask to be flipped, increasing

  bool IsFeasible() const { return status.ok(); }
  bool IsCancelled() const { return status.code() == StatusCode::kCancelled; }

  /// Whether it is worth being kept instead of `other`.
  bool Improves(const Fit& other) const {
    if (IsFeasible() != other.IsFeasible()) return IsFeasible();
    if (!IsFeasible()) return true;  // margins of different proofs say nothing of each other
    const double before = other.result.kkt.primal;
    return result.kkt.primal < before - kLeastDecrease * std::abs(before);
  }
};

std::vector<Index> ActiveEdges(const Triangulation& t, const CoherentAngles& angles) {
  std::vector<Index> active;
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    if (t.twin[h] == kNone) continue;
    const double theta = kPi - angles.value[h] - angles.value[t.twin[h]];
    if (theta < angles.epsilon + kActive) active.push_back(e);
  }
  return active;
}

/// The sides of the faces that a proof points at, or at a vertex of which; without a proof all.
std::vector<Index> CarryingEdges(const Triangulation& t, const InfeasibilityCertificate& proof) {
  std::vector<bool> named(t.num_edges(), proof.empty()), carries(t.num_vertices, false);
  for (const Index v : proof.carrying_vertices) carries[v] = true;
  for (const Index f : proof.carrying_faces) {
    for (Index h = 3 * f; h < 3 * f + 3; ++h) named[t.edge[h]] = true;
  }
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (carries[t.vertex[h]]) named[t.edge[h]] = true;  // the side opposite
  }
  std::vector<Index> edges;
  for (Index e = 0; e < t.num_edges(); ++e) {
    if (named[e]) edges.push_back(e);
  }
  return edges;
}

class Retriangulation {
 public:
  Retriangulation(const FlattenJob& job, const AngleSolver& solver,
                  std::shared_ptr<const AngleObjective> objective)
      : job_(job), solver_(solver), objective_(std::move(objective)) {}

  /// The fit on that triangulation, from multipliers (empty: from 0).
  Fit FitOn(IntrinsicTriangulation on, const Eigen::VectorXd& start) const {
    Fit fit;
    fit.on = std::move(on);
    const Triangulation& t = fit.on.triangulation;
    const IntrinsicSurface surface = MeasureSurface(t, fit.on.lengths);
    const ConeTargets targets = TransferTargets(job_.surface, job_.targets, surface);
    const AngleConstraints constraints(t, targets);
    const bool starts = start.size() == constraints.num_rows();
    const AngleFitProblem problem = {constraints, surface.angles.value, job_.options.epsilon,
                                     starts ? &start : nullptr};
    fit.status = FitAngles(problem, objective_, solver_, job_.control, &fit.result);
    fit.named = fit.IsFeasible() ? ActiveEdges(t, fit.result.angles)
                                 : CarryingEdges(t, fit.result.infeasibility);
    std::erase_if(fit.named, [&, locked = LockedEdges(fit.on)](Index e) { return locked[e]; });
    return fit;
  }

  /// Flags of the edges that the job locks, as far as they are there.
  std::vector<bool> LockedEdges(const IntrinsicTriangulation& on) const {
    std::vector<bool> locked(on.triangulation.num_edges(), false);
    for (std::size_t e = 0; job_.locked && e < job_.locked->size(); ++e) {
      if ((*job_.locked)[e] && on.edge_of_input[e] != kNone) locked[on.edge_of_input[e]] = true;
    }
    return locked;
  }

  /// With flips of the named edges: of active ones as far as each by itself lowers the objective
  /// where the angles stay what they are in the flat metric.
  IntrinsicTriangulation Flipped(const Fit& fit) const {
    if (!fit.IsFeasible()) {
      std::vector<Index> corners = CornersPerVertex(fit.on.triangulation);
      return FlipEdges(fit.on, fit.named, job_.targets, [&](const FlipComplex& flipped, Index h) {
        return EvensCorners(flipped, h, &corners);
      });
    }
    const CornerAngles reference = MeasureCornerAngles(fit.on.triangulation, fit.on.lengths);
    return FlipEdges(fit.on, fit.named, job_.targets, [&](const FlipComplex& flipped, Index h) {
      return LowersObjective(reference, fit.result.angles, flipped, h);
    });
  }

 private:
  /// Whether the poorest of the four vertices has more corners after the flip of h; counts them then.
  static bool EvensCorners(const FlipComplex& flipped, Index h, std::vector<Index>* corners) {
    const Index g = flipped.twin(h);
    Index& tail = (*corners)[flipped.vertex(h)];
    Index& tip = (*corners)[flipped.vertex(g)];
    Index& right = (*corners)[flipped.vertex(Triangulation::Next(h))];
    Index& left = (*corners)[flipped.vertex(Triangulation::Prev(h))];
    if (std::min(tail, tip) - 1 <= std::min(left, right)) return false;
    --tail;
    --tip;
    ++left;
    ++right;
    return true;
  }

  /// Whether six corners come nearer to their references by the flip of h. Four points on a circle:
  /// the angles after it follow from inscribed angles. With a -> b the edge before, c and d left and
  /// right of it, the new corners are, in the slots of h, Next(h), Prev(h) and of the twin g:
  ///   a: a_left + a_right,  d: b_left,  c: b_right;  b: b_left + b_right,  c: a_right,  d: a_left.
  bool LowersObjective(const CornerAngles& reference, const CoherentAngles& angles,
                       const FlipComplex& flipped, Index h) const {
    const Index g = flipped.twin(h);
    const Index slots[] = {h, Triangulation::Next(h), Triangulation::Prev(h),
                           g, Triangulation::Next(g), Triangulation::Prev(g)};
    const Eigen::VectorXd& alpha = angles.value;
    const double a_left = alpha[slots[1]], b_left = alpha[slots[2]];
    const double b_right = alpha[slots[4]], a_right = alpha[slots[5]];
    const double after[] = {a_left + a_right, b_left, b_right, b_left + b_right, a_right, a_left};
    double change = 0;
    for (int i = 0; i < 6; ++i) {
      const double angle = 2 * std::atan(std::sqrt(flipped.SquaredHalfTangent(slots[i])));
      change += Distance(angle, after[i]) - Distance(reference.value[slots[i]], alpha[slots[i]]);
    }
    return change < 0;
  }

  double Distance(double reference, double angle) const {
    return objective_->Distance(objective_->ClampReference(reference, job_.options.epsilon), angle)
        .value;
  }

  const FlattenJob& job_;
  const AngleSolver& solver_;
  const std::shared_ptr<const AngleObjective> objective_;
};

}  // namespace

Status Retriangulate(const FlattenJob& job, Certificate* certificate, FlatSurface* result) {
  const auto objective = AngleObjectiveOf(job.options);
  if (!objective.ok()) return objective.status();
  const auto solver = MakeAngleSolver(job.options.angle_solver);
  if (!solver.ok()) return solver.status();
  const Retriangulation fits(job, **solver, *objective);
  RetriangulationSummary& summary = Fill(&certificate->retriangulation);
  summary = {};
  Fit best = fits.FitOn(std::move(result->intrinsic), {});
  summary.active_edges_before = static_cast<int>(best.IsFeasible() ? best.named.size() : 0);
  const std::size_t flips_before = best.on.flips.size();
  const IntrinsicTriangulation first = best.on;
  while (!best.IsCancelled() && summary.retriangulation_rounds < job.options.retriangulate) {
    IntrinsicTriangulation flipped = fits.Flipped(best);
    if (flipped.flips.size() == best.on.flips.size()) break;
    ++summary.retriangulation_rounds;
    // Those of an infeasible fit lead nowhere.
    const Eigen::VectorXd start = best.IsFeasible() ? best.result.multipliers : Eigen::VectorXd();
    Fit next = fits.FitOn(std::move(flipped), start);
    if (!next.IsCancelled() && !next.Improves(best)) break;
    best = std::move(next);
  }
  if (!best.IsFeasible()) best.on = first;
  summary.active_edges_after = static_cast<int>(best.IsFeasible() ? best.named.size() : 0);
  summary.retriangulation_flips = static_cast<int>(best.on.flips.size() - flips_before);
  result->intrinsic = std::move(best.on);
  result->multipliers = best.IsFeasible() ? std::move(best.result.multipliers) : Eigen::VectorXd();
  return best.IsCancelled() ? best.status : Status();
}

}  // namespace cirque

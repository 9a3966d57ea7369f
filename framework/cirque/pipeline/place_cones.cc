#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "cirque/cones/cone.h"
#include "cirque/cones/curvature_peaks.h"
#include "cirque/cones/registry.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"
#include "cirque/pipeline/cone_stages.h"

namespace cirque {
namespace {

/// Of the default cones of a closed surface: more of them stay where SimpleConeTargets has them,
/// since moving each costs a solve.
constexpr int kMostMovedCones = 96, kMostMoves = 256, kMostSweeps = 30;

/// `count` cones moved to where the predicted angle distortion is least.
StatusOr<ConeTargets> MovedCones(const IntrinsicSurface& surface, int count) {
  const Triangulation& t = surface.triangulation;
  const IntrinsicTriangulation delaunay = MakeIntrinsicDelaunay(t, surface.lengths);
  const ConeProblem problem(MeasureSurface(delaunay.triangulation, delaunay.lengths),
                            {&surface, {}});
  const int sweeps = std::min(kMostSweeps, kMostMoves / count);
  const auto heuristic = MakeConeHeuristic("moving", {{"measure", "angle"},
                                                      {"cones", std::to_string(count)},
                                                      {"max_sweeps", std::to_string(sweeps)}});
  if (!heuristic.ok()) return heuristic.status();
  const StatusOr<std::vector<Cone>> cones = (*heuristic)->Choose(problem);
  return cones.ok() ? ConeTargetsOf(t, *cones) : cones.status();
}

StatusOr<std::vector<Cone>> ChooseCones(const ConeProblem& problem,
                                        const ParameterizeOptions& options) {
  if (!options.cones.empty()) {
    const auto heuristic = ParseConeHeuristic(options.cones, options.cone_budget);
    return heuristic.ok() ? (*heuristic)->Choose(problem) : heuristic.status();
  }
  if (options.cone_budget >= 0) {
    return Status::InvalidInput("a cone budget needs a heuristic: name it as `cones`, one of " +
                                Join(ConeHeuristics().Names()));
  }
  const IntrinsicSurface& source = *problem.source().surface;
  const StatusOr<ConeTargets> targets = DefaultTargets(source);
  if (!targets.ok()) return targets.status();
  return ConesOf(source.triangulation, *targets);
}

constexpr double kSpareCorner = 0.5, kLeastAngle = kPi / 4;

class Repair {
 public:
  Repair(const IntrinsicSurface& surface, const ConeTargets& targets,
         const InfeasibilityCertificate& proof)
      : t_(surface.triangulation),
        corners_(surface.corners),
        boundary_(surface.boundary),
        pointed_at_(surface.triangulation.num_vertices, false) {
    const Triangulation& t = t_;
    repair_.targets = targets;
    std::vector<bool> carries(t.num_vertices, false);
    for (const Index v : proof.carrying_vertices) carries[v] = true;
    for (Index h = 0; h < t.num_halfedges(); ++h) {
      for (const Index v : {t.vertex[h], t.Tail(h), t.Tip(h)}) {
        if (carries[v] && IsCone(t.vertex[h])) pointed_at_[t.vertex[h]] = true;
      }
    }
    if (std::find(pointed_at_.begin(), pointed_at_.end(), true) != pointed_at_.end()) return;
    for (Index v = 0; v < t.num_vertices; ++v) pointed_at_[v] = IsCone(v);
  }

  ConeRepair Run(int round) {
    for (Index v = 0; v < t_.num_vertices; ++v) {
      if (round == 1 && pointed_at_[v]) Move(v);
      if (round > 1 && IsCone(v)) Widen(v, (round - 1) * kPi / (pointed_at_[v] ? 4 : 16));
    }
    return repair_;
  }

 private:
  bool IsCone(Index v) const {
    const ConeTargets& targets = repair_.targets;
    return !boundary_[v] && !(targets.lower[v] == 2 * kPi && targets.upper[v] == 2 * kPi);
  }

  void Move(Index v) {
    Index best = v;
    for (Index h = 0; h < t_.num_halfedges(); ++h) {
      if (t_.Tail(h) != v) continue;
      const Index w = t_.Tip(h);
      if (!boundary_[w] && !IsCone(w) && corners_[w] > corners_[best]) best = w;
    }
    if (best == v) return;
    std::swap(repair_.targets.lower[v], repair_.targets.lower[best]);
    std::swap(repair_.targets.upper[v], repair_.targets.upper[best]);
    ++repair_.moved;
  }

  void Widen(Index v, double width) {
    double& lower = repair_.targets.lower[v];
    double& upper = repair_.targets.upper[v];
    const double greatest = kPi * (corners_[v] - kSpareCorner);
    lower = std::min(lower, std::max(kLeastAngle, lower - width));
    upper = std::max(upper, std::min(greatest, upper + width));
    if (pointed_at_[v]) ++repair_.widened;
  }

  const Triangulation& t_;
  const std::vector<Index>& corners_;
  const std::vector<bool>& boundary_;
  std::vector<bool> pointed_at_;
  ConeRepair repair_;
};

}  // namespace

StatusOr<ConeTargets> DefaultTargets(const IntrinsicSurface& surface) {
  const Triangulation& t = surface.triangulation;
  if (!BoundaryLoops(t).empty()) return FreeBoundaryTargets(t);
  StatusOr<ConeTargets> simple = SimpleConeTargets(surface);
  if (!simple.ok()) return simple;
  const auto count = static_cast<int>(ConesOf(t, *simple).size());
  if (count == 0 || count > kMostMovedCones) return simple;
  const StatusOr<ConeTargets> moved = MovedCones(surface, count);
  return moved.ok() ? moved : simple;
}

StatusOr<ConeTargets> PlaceCones(const IntrinsicSurface& surface, const FileVertices& file,
                                 const ParameterizeOptions& options) {
  const Triangulation& t = surface.triangulation;
  const ParameterizeOptions plain;
  if (options.cones == plain.cones && options.cone_budget == plain.cone_budget &&
      options.cone_angles == plain.cone_angles) {
    return DefaultTargets(surface);
  }
  const StatusOr<ConeAngleOptions> angles = ParseConeAngles(options.cone_angles);
  if (!angles.ok()) return angles.status();
  const IntrinsicTriangulation delaunay = MakeIntrinsicDelaunay(t, surface.lengths);
  const ConeProblem problem(MeasureSurface(delaunay.triangulation, delaunay.lengths),
                            {&surface, file});
  StatusOr<std::vector<Cone>> cones = ChooseCones(problem, options);
  if (!cones.ok()) return cones.status();
  cones = ApplyConeAngles(problem, *std::move(cones), *angles);
  if (!cones.ok()) return cones.status();
  return ConeTargetsOf(t, *cones);
}

ConeRepair RepairCones(const IntrinsicSurface& surface, const ConeTargets& targets,
                       const InfeasibilityCertificate& proof, int round) {
  return Repair(surface, targets, proof).Run(round);
}

}  // namespace cirque

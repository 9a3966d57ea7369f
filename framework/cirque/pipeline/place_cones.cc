#include "cirque/pipeline/place_cones.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "cirque/cones/cone.h"
#include "cirque/cones/curvature_peaks.h"
#include "cirque/cones/registry.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"

namespace cirque {
namespace {

/// Of the default cones of a closed surface: more of them stay where SimpleConeTargets has them,
/// since moving each costs a solve.
constexpr int kMostMovedCones = 96, kMostMoves = 256, kMostSweeps = 30;

/// `count` cones moved to where the predicted angle distortion is least.
StatusOr<ConeTargets> MovedCones(const Triangulation& t, const EdgeLengths& lengths, int count) {
  const IntrinsicTriangulation delaunay = MakeIntrinsicDelaunay(t, lengths);
  const ConeProblem problem(delaunay.triangulation, delaunay.lengths, {&t, &lengths, {}});
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
  const ConeSource& source = problem.source();
  const StatusOr<ConeTargets> targets = DefaultTargets(*source.triangulation, *source.lengths);
  if (!targets.ok()) return targets.status();
  return ConesOf(*source.triangulation, *targets);
}

}  // namespace

StatusOr<ConeTargets> DefaultTargets(const Triangulation& t, const EdgeLengths& lengths) {
  if (!BoundaryLoops(t).empty()) return FreeBoundaryTargets(t);
  StatusOr<ConeTargets> simple = SimpleConeTargets(t, lengths);
  if (!simple.ok()) return simple;
  const auto count = static_cast<int>(ConesOf(t, *simple).size());
  if (count == 0 || count > kMostMovedCones) return simple;
  const StatusOr<ConeTargets> moved = MovedCones(t, lengths, count);
  return moved.ok() ? moved : simple;
}

StatusOr<ConeTargets> PlaceCones(const IntrinsicSurface& surface, const FileVertices& file,
                                 const ParameterizeOptions& options) {
  const Triangulation& t = surface.triangulation;
  const EdgeLengths& lengths = surface.lengths;
  const ParameterizeOptions plain;
  if (options.cones == plain.cones && options.cone_budget == plain.cone_budget &&
      options.cone_angles == plain.cone_angles) {
    return DefaultTargets(t, lengths);
  }
  const StatusOr<ConeAngleOptions> angles = ParseConeAngles(options.cone_angles);
  if (!angles.ok()) return angles.status();
  const IntrinsicTriangulation delaunay = MakeIntrinsicDelaunay(t, lengths);
  const ConeProblem problem(delaunay.triangulation, delaunay.lengths, {&t, &lengths, file});
  StatusOr<std::vector<Cone>> cones = ChooseCones(problem, options);
  if (!cones.ok()) return cones.status();
  cones = ApplyConeAngles(problem, *std::move(cones), *angles);
  if (!cones.ok()) return cones.status();
  return ConeTargetsOf(t, *cones);
}

}  // namespace cirque

#include "cirque/pipeline/place_cones.h"

#include <string>
#include <utility>
#include <vector>

#include "cirque/cones/cone_angles.h"
#include "cirque/cones/registry.h"
#include "cirque/cones/simple_cones.h"
#include "cirque/core/name_with_options.h"
#include "cirque/mesh/intrinsic_delaunay.h"

namespace cirque {
namespace {

/// The heuristic named, the budget among its options.
StatusOr<std::shared_ptr<const ConeHeuristic>> NamedHeuristic(const ParameterizeOptions& options) {
  StatusOr<NameWithOptions> named = ParseNameWithOptions(options.cones);
  if (!named.ok()) return named.status().In("cones");
  if (options.cone_budget >= 0) named->options["cones"] = std::to_string(options.cone_budget);
  return MakeConeHeuristic(named->name, named->options);
}

StatusOr<std::vector<Cone>> ChooseCones(const ConeProblem& problem,
                                        const ParameterizeOptions& options) {
  if (!options.cones.empty()) {
    const auto heuristic = NamedHeuristic(options);
    return heuristic.ok() ? (*heuristic)->Place(problem) : heuristic.status();
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
  return SimpleConeTargets(t, lengths);
}

StatusOr<ConeTargets> PlaceCones(const Triangulation& t, const EdgeLengths& lengths,
                                 const FileVertices& file, const ParameterizeOptions& options) {
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

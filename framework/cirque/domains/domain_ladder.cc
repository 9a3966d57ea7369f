#include "cirque/domains/domain_ladder.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "cirque/domains/half_plane_chart.h"
#include "cirque/domains/refine_on_shape.h"
#include "cirque/domains/sphere_pole.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/pipeline/road_keeper.h"

namespace cirque {
namespace {

constexpr int kMoreIterations = 10;  ///< times
constexpr Index kPolesTried = 4;     ///< most that a domain tries by itself

/// A road taken.
struct Taken {
  Status status;
  RoadEnd end;
  SurfaceMap map;
};

/// Where the ladder stands.
struct Ended {
  const Domain& domain;
  const Surface& surface;
  const MapRequest& asked;
  RoadEnd end;  ///< of the request as it was asked for
};

const ParameterizeOptions& DefaultOptions() {
  static const ParameterizeOptions kDefault;
  return kDefault;
}

/// Solves that are the plane's have a ladder of their own.
bool SolvesHere(const Ended& at) { return !at.domain.Reads("pattern"); }

// When rungs apply.

bool IsRough(const Ended& at) {
  return at.end == RoadEnd::kImprecise && at.domain.Reads("refine_map") &&
         at.asked.options.refine_map == DefaultOptions().refine_map;
}

bool CollapsesInPolygon(const Ended& at) {
  return at.end == RoadEnd::kUnrepresentable && at.domain.Reads("corners") && !at.asked.targets;
}

bool NotConverged(const Ended& at) { return at.end == RoadEnd::kNotConverged && SolvesHere(at); }

bool MayIterateMore(const Ended& at) {
  return NotConverged(at) && at.asked.options.max_iterations == DefaultOptions().max_iterations;
}

bool NotQuadratic(const Ended& at) {
  return NotConverged(at) && at.asked.options.angle_objective != "quadratic";
}

bool SolverIsFree(const Ended& at) {
  return NotConverged(at) && at.asked.options.angle_solver == DefaultOptions().angle_solver;
}

bool PoleIsFree(const Ended& at) {
  const bool helps = at.end == RoadEnd::kNotConverged || at.end == RoadEnd::kInfeasible;
  return helps && at.domain.Reads("pole") && at.asked.shape.pole == kNone;
}

// What rungs change; false: nothing.

bool Rest(const Ended& /*at*/, int /*number*/, MapRequest* request) {
  request->options.refine_map = kRefineToRest;
  return true;
}

bool SpreadBoundary(const Ended& at, int number, MapRequest* request) {
  request->spread_boundary = true;
  const bool refines = at.asked.options.refine_map == DefaultOptions().refine_map;
  return !refines || Rest(at, number, request);
}

bool IterateMore(const Ended& /*at*/, int times, MapRequest* request) {
  request->options.max_iterations *= times;
  return true;
}

bool FitQuadratic(const Ended& /*at*/, int /*number*/, MapRequest* request) {
  request->options.own_objective = nullptr;
  request->options.angle_objective = "quadratic";
  return true;
}

bool FitByInteriorPoint(const Ended& at, int number, MapRequest* request) {
  request->options.angle_solver = "interior_point";
  return FitQuadratic(at, number, request);
}

/// Vertices that suit as pole, the best first.
std::vector<Index> Poles(const Surface& surface, Index count) {
  const Triangulation& t = surface.triangulation;
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  if (BoundaryLoops(t).empty()) return PoleCandidates(surface, {t, lengths, {}, {}}, count);
  return RankPoles(MeasureSurface(t, lengths));
}

/// Of the candidates beyond those that the domain tries itself the k-th.
bool MovePole(const Ended& at, int k, MapRequest* request) {
  const auto beyond = static_cast<std::size_t>(kPolesTried + k - 1);
  const std::vector<Index> poles = Poles(at.surface, static_cast<Index>(2 * beyond + 1));
  if (beyond >= poles.size()) return false;
  request->shape.pole = poles[beyond];
  return true;
}

/// A line of the ladder.
struct Rung {
  const char* name;
  const char* made_with;  ///< what a map of it is made with, for people
  bool same_problem;      ///< a proof on it is one about what was asked for
  bool (*applies)(const Ended&);
  bool (*change)(const Ended&, int number, MapRequest*);
  int number;  ///< what `change` counts
};

constexpr Rung kRungs[] = {
    {"refined_to_rest", "refinement until it came to rest", true, IsRough, Rest, 0},
    {"spread_boundary", "a boundary spread out along its sides", true, CollapsesInPolygon,
     SpreadBoundary, 0},
    {"more_iterations", "more iterations", true, MayIterateMore, IterateMore, kMoreIterations},
    {"quadratic", "the quadratic objective of the angles", true, NotQuadratic, FitQuadratic, 0},
    {"interior_point", "angles by the interior point", true, SolverIsFree, FitByInteriorPoint, 0},
    {"other_pole_1", "another pole", false, PoleIsFree, MovePole, 1},
    {"other_pole_2", "another pole", false, PoleIsFree, MovePole, 2},
    {"other_pole_3", "another pole", false, PoleIsFree, MovePole, 3},
};

class Climb {
 public:
  Climb(const Domain& domain, const Surface& surface, const MapRequest& request,
        const SolveControl& control)
      : domain_(domain), surface_(surface), request_(request), control_(control) {}

  Status Run(SurfaceMap* map) {
    const std::shared_ptr<Taken> asked = Take(request_, kAsAsked);
    keeper_.Keep(asked);
    const RoadEnd first = asked->end;
    const bool settled = first == RoadEnd::kMap || first == RoadEnd::kStopped;
    const bool may_climb = domain_.Reads("strict") && !domain_.Gives("flat");
    if (!settled && may_climb && !request_.options.strict) TryRungs(first);
    if (keeper_.HasTriedOthers()) keeper_.Describe(first);
    *map = std::move(keeper_.kept().map);
    return keeper_.kept().status;
  }

 private:
  std::shared_ptr<Taken> Take(const MapRequest& request, const char* name) {
    auto taken = std::make_shared<Taken>();
    const Timer timer;
    taken->status = domain_.map(surface_, request, control_, &taken->map);
    keeper_.Note(name, timer.Seconds(), taken.get());
    return taken;
  }

  void TryRungs(RoadEnd first) {
    const Ended at{domain_, surface_, request_, first};
    for (const Rung& rung : kRungs) {
      MapRequest next = request_;
      if (!rung.applies(at) || !rung.change(at, rung.number, &next)) continue;
      const std::shared_ptr<Taken> taken = Take(next, rung.name);
      keeper_.CountRung();
      if (taken->status.code() == StatusCode::kCancelled) return keeper_.Keep(taken);
      if (keeper_.KeepBest(rung.made_with, rung.same_problem, taken)) return;
    }
  }

  const Domain& domain_;
  const Surface& surface_;
  const MapRequest& request_;
  const SolveControl& control_;
  RoadKeeper<Taken> keeper_;
};

}  // namespace

Status ClimbDomainLadder(const Domain& domain, const Surface& surface, const MapRequest& request,
                         const SolveControl& control, SurfaceMap* map) {
  return Climb(domain, surface, request, control).Run(map);
}

std::vector<std::string> DomainLadderRungs() {
  std::vector<std::string> names;
  for (const Rung& rung : kRungs) names.push_back(rung.name);
  return names;
}

}  // namespace cirque

#include "cirque/pipeline/ladder.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cirque/cones/cone.h"
#include "cirque/pipeline/cone_stages.h"
#include "cirque/pipeline/flatten_by_equivalence.h"
#include "cirque/pipeline/road_keeper.h"

namespace cirque {
namespace {

constexpr int kMoreIterations = 10;       ///< times
constexpr int kLeastCones = 8;            ///< of a heuristic
constexpr int kMostCones = 512;           ///< of a heuristic that places or moves them one by one
constexpr double kRadiiTolerance = 1e-9;  ///< [rad], of SolveLogRadii

/// The last road tried.
struct Ended {
  const LadderStart& start;
  const Road& road;
  RoadEnd end;
  const Parameterization& map;
  const ConeTargets& asked_for;     ///< the targets of the road that was asked for
  RoadEnd asked_end;                ///< how that ended
  std::optional<int>* least_cones;  ///< of the rungs that place them, once one has asked
};

const ParameterizeOptions& Asked(const Ended& last) { return last.start.asked.options; }

bool FailedInRadii(const Ended& last) {
  const std::optional<RadiiSummary>& radii = last.map.certificate.radii;
  return last.end == RoadEnd::kNotConverged && radii && !(radii->radii_gradient <= kRadiiTolerance);
}

bool FailedInAngles(const Ended& last) {
  return last.end == RoadEnd::kNotConverged && !FailedInRadii(last);
}

/// Neither the user nor a rung before set the limit.
bool MayIterateMore(const Ended& last) {
  return last.road.options.max_iterations == ParameterizeOptions().max_iterations;
}

/// Whether the cones are the program's to choose.
bool MayChooseCones(const Ended& last) {
  const LadderStart& start = last.start;
  return !start.asked.targets && !start.cut_given && !Asked(last).AsksForCones();
}

/// Whether the cones that are there are a heuristic's.
bool MayRepairCones(const Ended& last) {
  return !last.start.asked.targets && !Asked(last).cones.starts_with("given");
}

/// What is about angles and radii is of no use to conformal equivalence.
bool ByCircles(const Ended& last) { return last.road.options.pattern == PatternKind::kCircle; }

// When rungs apply.

bool OpenedAlongCut(const Ended& last) {
  return last.start.cut_given && Asked(last).seams == SeamKind::kAuto &&
         !last.start.asked.targets && !Asked(last).AsksForCones();
}

bool RadiiNeedMore(const Ended& last) { return FailedInRadii(last) && MayIterateMore(last); }

bool AnglesNeedMore(const Ended& last) { return FailedInAngles(last) && MayIterateMore(last); }

bool EquivalenceMayDo(const Ended& last) {
  const bool may_end_otherwise = last.asked_end == RoadEnd::kInfeasible ||
                                 last.asked_end == RoadEnd::kNotConverged ||
                                 last.asked_end == RoadEnd::kUnrepresentable;
  return may_end_otherwise && ByCircles(last) &&
         Asked(last).triangulation != SolvedTriangulation::kInput &&
         HasEquivalentMetric(last.start.surface, last.asked_for);
}

bool NotQuadratic(const Ended& last) {
  return ByCircles(last) && last.end == RoadEnd::kNotConverged &&
         last.road.options.angle_objective != "quadratic";
}

bool DualWanders(const Ended& last) {
  return ByCircles(last) && FailedInAngles(last) &&
         Asked(last).angle_solver == ParameterizeOptions().angle_solver;
}

/// Flips among needles cost digits of lengths, which a fit on the input's own triangles has. Where
/// there are cones others help more often.
bool ImpreciseByFlips(const Ended& last) {
  return last.end == RoadEnd::kImprecise && ByCircles(last) &&
         last.road.options.triangulation == SolvedTriangulation::kDelaunay &&
         ConesOf(last.start.surface.triangulation, last.asked_for).empty();
}

bool ConesInfeasible(const Ended& last) {
  return last.end == RoadEnd::kInfeasible && MayRepairCones(last) &&
         !last.map.flat.infeasibility.empty();
}

// What rungs change; false: nothing.

bool KeepSeamsRigid(const Ended& /*last*/, int /*number*/, Road* road) {
  road->options.seams = SeamKind::kRigid;
  return true;
}

bool IterateMore(const Ended& last, int times, Road* road) {
  road->options.max_iterations = times * Asked(last).max_iterations;
  return true;
}

bool FitQuadratic(const Ended& /*last*/, int /*number*/, Road* road) {
  road->options.own_objective = nullptr;
  road->options.angle_objective = "quadratic";
  return true;
}

bool FitByInteriorPoint(const Ended& /*last*/, int /*number*/, Road* road) {
  road->options.own_objective = nullptr;
  road->options.angle_objective = "quadratic";
  road->options.angle_solver = "interior_point";
  return true;
}

bool SolveOnInput(const Ended& /*last*/, int /*number*/, Road* road) {
  road->options.triangulation = SolvedTriangulation::kInput;
  return true;
}

bool Repair(const Ended& last, int round, Road* road) {
  ConeRepair repaired =
      RepairCones(last.start.surface, last.map.targets, last.map.flat.infeasibility, round);
  if (repaired.moved + repaired.widened == 0) return false;
  ConeRepairSummary& summary = Fill(&road->repair);
  summary.cone_repairs = round;
  summary.cones_moved += repaired.moved;
  summary.cones_widened = repaired.widened;
  road->targets = std::move(repaired.targets);
  return true;
}

/// How many cones to begin with: as many as the road that was asked for, which had the default's, or
/// as one chart needs where that is what failed.
int LeastConesAfter(const Ended& last) {
  const IntrinsicSurface& surface = last.start.surface;
  const auto of_default = static_cast<int>(ConesOf(surface.triangulation, last.asked_for).size());
  const int least = std::max(kLeastCones, of_default);
  const bool wide = last.end == RoadEnd::kImprecise || last.end == RoadEnd::kUnrepresentable;
  return wide ? ConesForOneChart(surface, least) : least;
}

/// The road that was asked for, with other cones; what was learnt of iterations stays.
void AskAnew(const Ended& last, std::string cones, Road* road) {
  const int max_iterations = road->options.max_iterations;
  *road = last.start.asked;
  road->options.max_iterations = max_iterations;
  road->options.cones = std::move(cones);
}

/// The same, so many times as many as to begin with.
bool PlaceAnew(const Ended& last, const std::string& heuristic, int factor, Road* road) {
  const Triangulation& t = last.start.surface.triangulation;
  if (!*last.least_cones) *last.least_cones = LeastConesAfter(last);
  const int count = factor * **last.least_cones;
  if (count > kMostCones || (factor > 1 && count > t.num_vertices / 2)) return false;
  AskAnew(last, heuristic, road);
  road->options.cone_budget = count;
  return true;
}

bool PlaceMoving(const Ended& last, int factor, Road* road) {
  return PlaceAnew(last, "moving:measure=angle", factor, road);
}

bool PlaceGreedy(const Ended& last, int factor, Road* road) {
  return PlaceAnew(last, "greedy", factor, road);
}

bool PlaceL1(const Ended& last, int factor, Road* road) {
  return PlaceAnew(last, "l1", factor, road);
}

constexpr char kWhereCurved[] = "curvature_peaks:share=";

/// Cones wherever the surface is curved: at last its own metric, unfolded, whose angles are coherent.
bool PlaceWhereCurved(const Ended& last, int share_in_10000, Road* road) {
  AskAnew(last, kWhereCurved + fmt::format("{}", share_in_10000 / 1e4), road);
  return true;
}

/// The road that was asked for with its own targets, by conformal equivalence.
bool TakeEquivalence(const Ended& last, int /*number*/, Road* road) {
  *road = last.start.asked;
  road->targets = last.asked_for;
  road->options.pattern = PatternKind::kEquivalence;
  road->options.refine_cones = 0;
  return true;
}

/// A line of the ladder.
struct Rung {
  const char* name;
  const char* made_with;  ///< what a map of it is made with, for people
  bool same_targets;      ///< a proof on it is one about the road that was asked for
  bool (*applies)(const Ended&);
  bool (*change)(const Ended&, int number, Road*);
  int number;  ///< what `change` counts
};

/// Also for maps of more than kDistorted in the mean; the last where one before led to those.
constexpr Rung kCurved[] = {{"curved_50", "cones where half of the curvature is", false,
                             MayChooseCones, PlaceWhereCurved, 5000},
                            {"curved_99", "cones where 99 % of the curvature are", false,
                             MayChooseCones, PlaceWhereCurved, 9900},
                            {"unfolded", "cones wherever the surface is curved", false,
                             MayChooseCones, PlaceWhereCurved, 10000}};
constexpr double kDistorted = 3;        ///< mean quasi-conformal distortion of a map of no use
constexpr double kLessDistorted = 0.5;  ///< of what it is above 1, for which longer seams are taken

constexpr Rung kRungs[] = {
    {"rigid_seams", "rigid seams along the cut", false, OpenedAlongCut, KeepSeamsRigid, 0},
    {"more_iterations", "more iterations for the radii", true, RadiiNeedMore, IterateMore,
     kMoreIterations},
    {"quadratic", "the quadratic objective of the angles", true, NotQuadratic, FitQuadratic, 0},
    {"quadratic_more_iterations", "the quadratic objective and more iterations for the radii", true,
     RadiiNeedMore, IterateMore, kMoreIterations},
    {"interior_point", "angles by the interior point", true, DualWanders, FitByInteriorPoint, 0},
    {"input_triangulation", "the input's own triangulation", false, ImpreciseByFlips, SolveOnInput,
     0},
    {"move_cones", "moved cones", false, ConesInfeasible, Repair, 1},
    {"widen_cones_1", "moved cones of wider angles", false, ConesInfeasible, Repair, 2},
    {"widen_cones_2", "moved cones of wider angles", false, ConesInfeasible, Repair, 3},
    {"widen_cones_3", "moved cones of wider angles", false, ConesInfeasible, Repair, 4},
    {"widen_cones_4", "moved cones of wider angles", false, ConesInfeasible, Repair, 5},
    {"greedy", "cones by greedy", false, MayChooseCones, PlaceGreedy, 1},
    {"moving_2", "twice as many cones by moving", false, MayChooseCones, PlaceMoving, 2},
    {"moving_4", "four times as many cones by moving", false, MayChooseCones, PlaceMoving, 4},
    {"greedy_8", "eight times as many cones by greedy", false, MayChooseCones, PlaceGreedy, 8},
    {"moving", "cones by moving", false, MayChooseCones, PlaceMoving, 1},
    {"l1", "cones by l1", false, MayChooseCones, PlaceL1, 1},
    kCurved[0],
    kCurved[1],
    kCurved[2],
    {"more_iterations_for_angles", "more iterations for the angles", true, AnglesNeedMore,
     IterateMore, kMoreIterations},
    {"equivalence", "discrete conformal equivalence instead of a circle pattern", false,
     EquivalenceMayDo, TakeEquivalence, 0},
};

/// A road taken.
struct Taken {
  Road road;
  Status status;
  RoadEnd end;
  Parameterization map;
};

class Climb {
 public:
  Climb(const LadderStart& start, const TakeARoad& take) : start_(start), take_(take) {}

  Status Run(Parameterization* result) {
    last_ = Take(start_.asked, kAsAsked);
    keeper_.Keep(last_);
    const RoadEnd first = last_->end;
    const std::shared_ptr<Taken> asked = last_;
    const bool settled = first == RoadEnd::kMap || first == RoadEnd::kStopped;
    if (!start_.asked.options.strict) {
      if (!settled) TryRungs();
      if (first != RoadEnd::kStopped) ReduceDistortion(*asked);
      if (keeper_.HasTriedOthers() || !settled) keeper_.Describe(first);
    }
    *result = std::move(keeper_.kept().map);
    return keeper_.kept().status;
  }

 private:
  std::shared_ptr<Taken> Take(const Road& road, const char* name) {
    auto taken = std::make_shared<Taken>(Taken{road, {}, RoadEnd::kStopped, {}});
    const Timer timer;
    taken->status = take_(road, &taken->map);
    taken->map.certificate.cone_repair = road.repair;
    keeper_.Note(name, timer.Seconds(), taken.get());
    return taken;
  }

  /// Takes a rung's road; null: it does not apply. One that was cancelled is kept.
  std::shared_ptr<Taken> TakeRung(const Rung& rung, const Ended& last) {
    Road next = last.road;
    if (!rung.applies(last) || !rung.change(last, rung.number, &next)) return nullptr;
    std::shared_ptr<Taken> taken = Take(next, rung.name);
    keeper_.CountRung();
    if (taken->status.code() == StatusCode::kCancelled) keeper_.Keep(taken);
    return taken;
  }

  /// How much the kept map is distorted where other cones may be chosen: the image of a disk that is
  /// not cut stays whole.
  double Distortion() const {
    const Taken& kept = keeper_.kept();
    const std::optional<DistortionSummary>& distortion = kept.map.certificate.distortion;
    const bool counts = kept.status.ok() && distortion && !kept.map.cut.IsEmpty() &&
                        kept.road.options.refine_map == ParameterizeOptions().refine_map;
    return counts ? distortion->quasi_conformal_mean : 1;
  }

  /// Cones wherever the surface is curved, instead of a map of no use.
  void ReduceDistortion(const Taken& asked) {
    std::optional<int> least_cones;
    for (const Rung& rung : kCurved) {
      const double distortion = Distortion();
      if (!(distortion > kDistorted)) return;
      const bool is_last = &rung == std::end(kCurved) - 1;
      const bool is_cut_anyway = keeper_.kept().road.options.cones.starts_with(kWhereCurved);
      if (keeper_.HasTried(rung.name) || (is_last && !is_cut_anyway)) continue;
      const Ended last{start_,    asked.road,  asked.end, asked.map, asked.map.targets,
                       asked.end, &least_cones};
      const std::shared_ptr<Taken> taken = ByCircles(last) ? TakeRung(rung, last) : nullptr;
      if (!taken || taken->status.code() == StatusCode::kCancelled) return;
      if (taken->end != RoadEnd::kMap) continue;
      const double mean = taken->map.certificate.distortion->quasi_conformal_mean;
      if (mean - 1 < kLessDistorted * (distortion - 1)) keeper_.Prefer(rung.made_with, taken);
    }
  }

  void TryRungs() {
    const std::shared_ptr<Taken> first = last_;
    std::optional<int> least_cones;
    for (const Rung& rung : kRungs) {
      const Ended last{start_,     last_->road, last_->end, last_->map, first->map.targets,
                       first->end, &least_cones};
      const std::shared_ptr<Taken> taken = TakeRung(rung, last);
      if (!taken) continue;
      if (taken->status.code() == StatusCode::kCancelled) return;
      if (taken->end == RoadEnd::kStopped) continue;  // a heuristic that finds no cones here
      last_ = taken;
      if (keeper_.KeepBest(rung.made_with, rung.same_targets, taken)) return;
    }
  }

  const LadderStart& start_;
  const TakeARoad& take_;
  std::shared_ptr<Taken> last_;  ///< that led somewhere
  RoadKeeper<Taken> keeper_;
};

}  // namespace

Status ClimbLadder(const LadderStart& start, const TakeARoad& take, Parameterization* result) {
  return Climb(start, take).Run(result);
}

std::vector<std::string> LadderRungs() {
  std::vector<std::string> names;
  for (const Rung& rung : kRungs) names.push_back(rung.name);
  return names;
}

}  // namespace cirque

#include "cirque/pipeline/ladder_rungs.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cirque/cones/cone.h"
#include "cirque/pipeline/cone_stages.h"
#include "cirque/pipeline/flatten_by_equivalence.h"

namespace cirque {
namespace {

constexpr int kMoreIterations = 10;       ///< times
constexpr int kLeastCones = 8;            ///< of a heuristic
constexpr int kMostCones = 512;           ///< of a heuristic that places or moves them one by one
constexpr Index kCoarse = 1000;           ///< vertices, at most
constexpr double kRadiiTolerance = 1e-9;  ///< [rad], of SolveLogRadii

const ParameterizeOptions& Asked(const EndedRoad& last) { return last.start.asked.options; }

bool FailedInRadii(const EndedRoad& last) {
  const std::optional<RadiiSummary>& radii = last.map.certificate.radii;
  return last.end == RoadEnd::kNotConverged && radii && !(radii->radii_gradient <= kRadiiTolerance);
}

bool FailedInAngles(const EndedRoad& last) {
  return last.end == RoadEnd::kNotConverged && !FailedInRadii(last);
}

/// Neither the user nor a rung before set the limit.
bool MayIterateMore(const EndedRoad& last) {
  return last.road.options.max_iterations == ParameterizeOptions().max_iterations;
}

/// Whether the cones are the program's to choose.
bool MayChooseCones(const EndedRoad& last) {
  const LadderStart& start = last.start;
  return !start.asked.targets && !start.cut_given && !Asked(last).AsksForCones();
}

/// Whether the cones that are there are a heuristic's.
bool MayRepairCones(const EndedRoad& last) {
  return !last.start.asked.targets && !Asked(last).cones.starts_with("given");
}

// When rungs apply.

bool OpenedAlongCut(const EndedRoad& last) {
  return last.start.cut_given && Asked(last).seams == SeamKind::kAuto &&
         !last.start.asked.targets && !Asked(last).AsksForCones();
}

bool RadiiNeedMore(const EndedRoad& last) { return FailedInRadii(last) && MayIterateMore(last); }

bool AnglesNeedMore(const EndedRoad& last) { return FailedInAngles(last) && MayIterateMore(last); }

bool EquivalenceMayDo(const EndedRoad& last) {
  const bool may_end_otherwise = last.asked_end == RoadEnd::kInfeasible ||
                                 last.asked_end == RoadEnd::kNotConverged ||
                                 last.asked_end == RoadEnd::kUnrepresentable;
  return may_end_otherwise && ByCircles(last) &&
         Asked(last).triangulation != SolvedTriangulation::kInput &&
         HasEquivalentMetric(last.start.surface(), last.asked_for);
}

bool NotQuadratic(const EndedRoad& last) {
  return ByCircles(last) && last.end == RoadEnd::kNotConverged &&
         last.road.options.angle_objective != "quadratic";
}

bool DualWanders(const EndedRoad& last) {
  return ByCircles(last) && FailedInAngles(last) &&
         Asked(last).angle_solver == ParameterizeOptions().angle_solver;
}

/// Flips among needles cost digits of lengths, which a fit on the input's own triangles has. Where
/// there are cones others help more often.
bool ImpreciseByFlips(const EndedRoad& last) {
  return last.end == RoadEnd::kImprecise && ByCircles(last) &&
         last.road.options.triangulation == SolvedTriangulation::kDelaunay &&
         ConesOf(last.start.surface().triangulation, last.asked_for).empty();
}

bool ConesInfeasible(const EndedRoad& last) {
  return last.end == RoadEnd::kInfeasible && MayRepairCones(last) &&
         !last.map.flat.infeasibility.empty();
}

/// Of a large surface that much of the curvature is as many cones as almost all of it.
bool MayChooseConesOfCoarse(const EndedRoad& last) {
  return MayChooseCones(last) && IsCoarse(last.start.surface());
}

// What rungs change; false: nothing.

bool KeepSeamsRigid(const EndedRoad& /*last*/, int /*number*/, Road* road) {
  road->options.seams = SeamKind::kRigid;
  return true;
}

bool IterateMore(const EndedRoad& last, int times, Road* road) {
  road->options.max_iterations = times * Asked(last).max_iterations;
  return true;
}

bool FitQuadratic(const EndedRoad& /*last*/, int /*number*/, Road* road) {
  road->options.own_objective = nullptr;
  road->options.angle_objective = "quadratic";
  return true;
}

bool FitByInteriorPoint(const EndedRoad& /*last*/, int /*number*/, Road* road) {
  road->options.own_objective = nullptr;
  road->options.angle_objective = "quadratic";
  road->options.angle_solver = "interior_point";
  return true;
}

bool SolveOnInput(const EndedRoad& /*last*/, int /*number*/, Road* road) {
  road->options.triangulation = SolvedTriangulation::kInput;
  return true;
}

bool Repair(const EndedRoad& last, int round, Road* road) {
  ConeRepair repaired =
      RepairCones(last.start.surface(), last.map.targets, last.map.flat.infeasibility, round);
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
int LeastConesAfter(const EndedRoad& last) {
  const Triangulation& t = last.start.surface().triangulation;
  const auto of_default = static_cast<int>(ConesOf(t, last.asked_for).size());
  const int least = std::max(kLeastCones, of_default);
  const bool wide = last.end == RoadEnd::kImprecise || last.end == RoadEnd::kUnrepresentable;
  return wide ? ConesForOneChart(last.start.site, least) : least;
}

/// The road that was asked for, with other cones; what was learnt of iterations stays.
void AskAnew(const EndedRoad& last, std::string cones, Road* road) {
  const int max_iterations = road->options.max_iterations;
  *road = last.start.asked;
  road->options.max_iterations = max_iterations;
  road->options.cones = std::move(cones);
}

/// The same, so many times as many as to begin with.
bool PlaceAnew(const EndedRoad& last, const std::string& heuristic, int factor, Road* road) {
  const Triangulation& t = last.start.surface().triangulation;
  if (!*last.least_cones) *last.least_cones = LeastConesAfter(last);
  const int count = factor * **last.least_cones;
  if (count > kMostCones || (factor > 1 && count > t.num_vertices / 2)) return false;
  AskAnew(last, heuristic, road);
  road->options.cone_budget = count;
  return true;
}

bool PlaceMoving(const EndedRoad& last, int factor, Road* road) {
  return PlaceAnew(last, "moving:measure=angle", factor, road);
}

bool PlaceGreedy(const EndedRoad& last, int factor, Road* road) {
  return PlaceAnew(last, "greedy", factor, road);
}

bool PlaceL1(const EndedRoad& last, int factor, Road* road) {
  return PlaceAnew(last, "l1", factor, road);
}

constexpr char kWhereCurved[] = "curvature_peaks:share=";

/// Cones wherever the surface is curved: at last its own metric, unfolded, whose angles are coherent.
bool PlaceWhereCurved(const EndedRoad& last, int share_in_10000, Road* road) {
  AskAnew(last, kWhereCurved + fmt::format("{}", share_in_10000 / 1e4), road);
  return true;
}

/// The road that was asked for with its own targets, by conformal equivalence.
bool TakeEquivalence(const EndedRoad& last, int /*number*/, Road* road) {
  *road = last.start.asked;
  road->targets = last.asked_for;
  road->options.pattern = PatternKind::kEquivalence;
  road->options.refine_cones = 0;
  return true;
}

constexpr Rung kMoreCones = {
    "moving_4", "four times as many cones by moving", false, MayChooseCones, PlaceMoving, 4};

constexpr Rung kCurved[] = {{"curved_50", "cones where half of the curvature is", false,
                             MayChooseCones, PlaceWhereCurved, 5000},
                            {"curved_90", "cones where 90 % of the curvature are", false,
                             MayChooseConesOfCoarse, PlaceWhereCurved, 9000},
                            {"curved_99", "cones where 99 % of the curvature are", false,
                             MayChooseCones, PlaceWhereCurved, 9900},
                            {"unfolded", "cones wherever the surface is curved", false,
                             MayChooseCones, PlaceWhereCurved, 10000}};

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
    kMoreCones,
    {"greedy_8", "eight times as many cones by greedy", false, MayChooseCones, PlaceGreedy, 8},
    {"moving", "cones by moving", false, MayChooseCones, PlaceMoving, 1},
    {"l1", "cones by l1", false, MayChooseCones, PlaceL1, 1},
    kCurved[0],
    kCurved[1],
    kCurved[2],
    kCurved[3],
    {"more_iterations_for_angles", "more iterations for the angles", true, AnglesNeedMore,
     IterateMore, kMoreIterations},
    {"equivalence", "discrete conformal equivalence instead of a circle pattern", false,
     EquivalenceMayDo, TakeEquivalence, 0},
};

}  // namespace

std::vector<std::string> LadderRungs() {
  std::vector<std::string> names;
  for (const Rung& rung : AllRungs()) names.push_back(rung.name);
  return names;
}

bool IsCoarse(const IntrinsicSurface& surface) {
  return surface.triangulation.num_vertices <= kCoarse;
}

std::span<const Rung> AllRungs() { return kRungs; }
const Rung& MoreConesRung() { return kMoreCones; }
std::span<const Rung> CurvedRungs() { return kCurved; }

bool IsConedWhereCurved(const Road& road) { return road.options.cones.starts_with(kWhereCurved); }

bool ByCircles(const EndedRoad& last) { return last.road.options.pattern == PatternKind::kCircle; }

}  // namespace cirque

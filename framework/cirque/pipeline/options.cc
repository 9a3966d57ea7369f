#include "cirque/pipeline/options.h"

#include <utility>

#include "cirque/angles/registry.h"
#include "cirque/cones/boundaries.h"
#include "cirque/cones/cone.h"
#include "cirque/cones/registry.h"
#include "cirque/core/enum_words.h"
#include "cirque/core/text.h"
#include "cirque/cuts/registry.h"
#include "cirque/energy/angle_objective.h"
#include "cirque/pipeline/finish_layout.h"
#include "cirque/solver/solver_strategy.h"

namespace cirque {
namespace {

using O = ParameterizeOptions;

std::vector<Option<O>> SolveOptions() {
  return {
      {"pattern", &O::pattern,
       "circle: the circle pattern of angles near the surface's; equivalence: discrete conformal "
       "equivalence, which exists for all cones with Gauss-Bonnet"},
      {"triangulation", &O::triangulation,
       "intrinsic Delaunay flips first, or the input's connectivity"},
      Option<O>("retriangulate", &O::retriangulate,
                "rounds of flips, after the Delaunay ones, of edges whose intersection angle is "
                "at its bound, or that a proof of infeasibility points at")
          .Between(0, 1000),
      Option<O>("angle_objective", &O::angle_objective,
                "the objective of the angle fit; quadratic and barrier are the thesis's")
          .OneOf(AngleObjectives().Names())
          .Formerly("angle_fit"),
      Option<O>("angle_solver", &O::angle_solver,
                "the solver of the angle fit, NAME or NAME:KEY=VALUE,...; names " +
                    Join(AngleSolverNames()))
          .Checked(CheckAngleSolver)
          .Formerly("angle_strategy"),
      Option<O>("radii_solver", &O::radii_solver,
                "the solver of the log radii, or of the log scales of equivalence, NAME or "
                "NAME:KEY=VALUE,...; names " +
                    Join(KnownStrategyNames()))
          .Checked(CheckSolverStrategy)
          .Formerly("strategy")};
}

std::vector<Option<O>> ConeOptions() {
  return {
      Option<O>("cones", &O::cones,
                "the cone heuristic, NAME or NAME:KEY=VALUE,...; names " +
                    Join(ConeHeuristics().Names()) +
                    "; without it a closed surface gets cones that stretch its triangles "
                    "little, a torus 8 where its area would else range over more than e^4, and "
                    "none otherwise")
          .Checked(CheckConeHeuristic),
      Option<O>("cone_budget", &O::cone_budget,
                "the most cones, but for what Gauss-Bonnet needs; -1: the heuristic's own default")
          .Between(-1, 1e6),
      Option<O>("cone_angles", &O::cone_angles,
                "free, pi/2, pi/3 (multiples of that), ranges or ranges:width=RADIANS")
          .Checked(CheckConeAngles),
      {"holonomy", &O::holonomy,
       "what directions turn by along every loop of the flat metric, handles too: free, or "
       "multiples of pi/2 or pi/3, for which cones get such angles, are moved, and the angles "
       "close what is left"},
      Option<O>(
          "integer_cells", &O::integer_cells,
          "with holonomy: move the map, least, until cones lie on points of a lattice of "
          "about so many cells and the translations across seams are vectors of it, so that "
          "a texture that repeats by the lattice (squares for pi/2, triangles for pi/3) has no "
          "seam; UVs are in cells; 0: no lattice")
          .Between(0, 100000000),
      Option<O>("boundary", &O::boundary,
                "what the boundary looks like: NAME or NAME:KEY=VALUE,...; free: as the angle fit "
                "has it; names " +
                    Join(BoundaryNames()))
          .Checked(CheckBoundaryShape),
      Option<O>("refine_cones", &O::refine_cones,
                "steps that lower the realised area distortion by the cones' angles")
          .Between(0, 1000)};
}

std::vector<Option<O>> RefinementOptions() {
  return {
      {"injective", &O::injective,
       "where the image overlaps itself: turn the boundary by other angles, least changed, or cut "
       "the image into charts, until no point is covered twice"},
      Option<O>("refine_map", &O::refine_map,
                "moves the finished map to less distortion, cones, seams and prescribed boundaries "
                "kept: none, NAME or NAME:KEY=VALUE,...; auto: around outliers, and the whole map "
                "where its mean asks for it; of lengths and areas: symmetric_dirichlet, arap, "
                "area:weight=W, on the plane; names " +
                    Join(RefineMapNames()))
          .Checked(CheckRefineMap)};
}

std::vector<Option<O>> CutOptions() {
  return {
      {"seams", &O::seams,
       "the two sides of a cut stay congruent, or the surface opened along it gets a free "
       "boundary; auto: that along a cut that is given without cones"},
      Option<O>("cut_cost", &O::cut_cost,
                "what the cut is short in, NAME or NAME:KEY=VALUE,...; names " +
                    Join(CutHeuristics().Names()))
          .Checked(CheckCutHeuristic),
      {"edge_costs", &O::edge_costs, "file of factors on that: 'from to cost' a line"},
      Option<O>("least_charts", &O::least_charts,
                "charts that the surface is cut into at least, all disks, by short borders; 0: as "
                "few as it takes")
          .Between(0, 1e6)};
}

std::vector<Option<O>> LimitingOptions() {
  return {Option<O>("epsilon", &O::epsilon,
                    "least corner and intersection angle; shrinks where it must")
              .Between(1e-12, 1)
              .Unit("rad"),
          Option<O>("solve_at", &O::solve_at,
                    "of a mesh with more faces: decimate it to about so many, map that, and carry "
                    "the map back to all vertices; 0: never")
              .Between(0, 1e9),
          Option<O>("exact_limit", &O::exact_limit, "the most faces of an exact map's overlay")
              .Between(1, 1e8),
          Option<O>("max_iterations", &O::max_iterations, "limit of each solve").Between(1, 1e6),
          {"strict", &O::strict,
           "stop where the road that was asked for leads to no map; otherwise other solvers, moved "
           "cones and cones by other heuristics are tried, and said in the certificate"}};
}

/// Rows of one group.
std::vector<Option<O>> About(const std::string& group, std::vector<Option<O>> rows) {
  for (Option<O>& row : rows) row = std::move(row).About(group);
  return rows;
}

}  // namespace

const OptionTable<ParameterizeOptions>& ParameterizeOptionTable() {
  static const OptionTable<O> kTable("parameterize", [] {
    const std::string solve = "Solver", cones = "Cones", cuts = "Cuts";
    auto rows = About(solve, SolveOptions());
    rows = Joined<O>(
        rows, {Option<O>("layout", &O::layout, "how the flat triangles are placed").About(solve)});
    rows = Joined<O>(rows, About(cones, ConeOptions()));
    rows = Joined<O>(rows, About(solve, RefinementOptions()));
    rows = Joined<O>(rows, About(cuts, CutOptions()));
    return Joined<O>(rows, About(solve, LimitingOptions()));
  }());
  return kTable;
}

namespace {

/// What conformal equivalence has no use for.
Status CheckPattern(const ParameterizeOptions& options) {
  if (options.pattern == PatternKind::kCircle) return Status();
  if (options.triangulation == SolvedTriangulation::kInput) {
    return Status::InvalidInput(
        "pattern = equivalence flips edges; leave triangulation = delaunay");
  }
  const auto shape = ParseBoundaryShape(options.boundary);
  if (shape.ok() && (*shape)->descent().steps > 0) {
    return Status::InvalidInput("boundary: steps follow the angle fit; they need pattern = circle");
  }
  if (options.refine_cones > 0) {
    return Status::InvalidInput("refine_cones follows the angle fit; it needs pattern = circle");
  }
  return Status();
}

/// What goes with rotations that are multiples.
Status CheckHolonomy(const ParameterizeOptions& options) {
  if (options.holonomy == HolonomyRule::kFree) return Status();
  const std::string rule = ToWord(options.holonomy);
  if (options.pattern != PatternKind::kCircle) {
    return Status::InvalidInput("holonomy = " + rule + " needs pattern = circle");
  }
  if (options.cone_angles != "free" && options.cone_angles != rule) {
    return Status::InvalidInput("holonomy = " + rule +
                                " needs cones of such angles; leave cone_angles free");
  }
  if (options.refine_cones > 0) {
    return Status::InvalidInput("refine_cones changes cones' angles; with holonomy = " + rule +
                                " they are multiples");
  }
  if (options.seams == SeamKind::kFree) {
    return Status::InvalidInput("holonomy = " + rule +
                                " is about rigid seams; leave seams = auto or rigid");
  }
  return Status();
}

/// What a lattice needs and does not go with.
Status CheckIntegers(const ParameterizeOptions& options) {
  if (options.integer_cells == 0) return Status();
  if (options.holonomy == HolonomyRule::kFree) {
    return Status::InvalidInput(
        "integer_cells needs rotations by multiples: holonomy = pi/2 (squares) or pi/3 "
        "(triangles)");
  }
  const std::pair<const char*, bool> others[] = {{"exact", options.exact},
                                                 {"injective", options.injective},
                                                 {"least_charts", options.least_charts > 1},
                                                 {"solve_at", options.solve_at > 0}};
  for (const auto& [name, asked] : others) {
    if (!asked) continue;
    return Status::InvalidInput(
        "integer_cells moves the map of the whole surface's own triangles; leave out " +
        std::string(name));
  }
  return Status();
}

}  // namespace

Status CheckOptions(const ParameterizeOptions& options) {
  if (Status s = ParameterizeOptionTable().Validate(options); !s.ok()) return s;
  if (Status s = CheckPattern(options); !s.ok()) return s;
  if (Status s = CheckHolonomy(options); !s.ok()) return s;
  if (Status s = CheckIntegers(options); !s.ok()) return s;
  if (options.own_cones && !options.cones.empty()) {
    return Status::InvalidInput("give own_cones or the name of a heuristic, not both");
  }
  if (options.cone_budget >= 0 && options.cones.empty()) {
    return Status::InvalidInput("a cone budget needs a heuristic: name it as `cones`, one of " +
                                Join(ConeHeuristics().Names()));
  }
  if (options.cone_budget < 0) return Status();
  return ParseConeHeuristic(options.cones, options.cone_budget).status().In("cone_budget");
}

StatusOr<std::shared_ptr<const AngleObjective>> AngleObjectiveOf(
    const ParameterizeOptions& options) {
  if (options.own_objective) return options.own_objective;
  return AngleObjectives().Find(options.angle_objective);
}

}  // namespace cirque

#include "cirque/pipeline/options.h"

#include "cirque/angles/registry.h"
#include "cirque/cones/cone.h"
#include "cirque/cones/registry.h"
#include "cirque/core/text.h"
#include "cirque/energy/angle_objective.h"
#include "cirque/pipeline/finish_layout.h"
#include "cirque/solver/solver_strategy.h"

namespace cirque {
namespace {

using O = ParameterizeOptions;

std::vector<Option<O>> SolveOptions() {
  return {{"triangulation", &O::triangulation,
           "intrinsic Delaunay flips first, or the input's connectivity"},
          Option<O>("angle_objective", &O::angle_objective,
                    "the objective of the angle fit; quadratic and barrier are the thesis's")
              .OneOf(AngleObjectives().Names())
              .Formerly("angle_fit"),
          Option<O>("angle_solver", &O::angle_solver, "the solver of the angle fit")
              .OneOf(AngleSolverNames())
              .Formerly("angle_strategy"),
          Option<O>("radii_solver", &O::radii_solver, "the solver of the log radii")
              .OneOf(KnownStrategyNames())
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
      Option<O>("refine_cones", &O::refine_cones,
                "steps that lower the realised area distortion by the cones' angles")
          .Between(0, 1000)};
}

std::vector<Option<O>> MapOptions() {
  return {
      Option<O>("refine_map", &O::refine_map,
                "moves the finished map to less distortion, cones, seams and prescribed boundaries "
                "kept: none, NAME or NAME:KEY=VALUE,...; auto: around outliers, and the whole map "
                "where its mean asks for it; names " +
                    Join(RefineMapNames()))
          .Checked(CheckRefineMap),
      {"seams", &O::seams,
       "the two sides of a cut stay congruent, or the surface opened along it gets a free "
       "boundary; auto: that along a cut that is given without cones"},
      {"cut_cost", &O::cut_cost, "what the cut is short in"},
      {"edge_costs", &O::edge_costs, "file of factors on that: 'from to cost' a line"}};
}

std::vector<Option<O>> LimitingOptions() {
  return {Option<O>("epsilon", &O::epsilon,
                    "least corner and intersection angle; shrinks where it must")
              .Between(1e-12, 1)
              .Unit("rad"),
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
    const std::string solve = "Solve", cones = "Cones", map = "Cut and layout";
    auto rows = About(solve, SolveOptions());
    rows = Joined<O>(
        rows, {Option<O>("layout", &O::layout, "how the flat triangles are placed").About(map)});
    rows = Joined<O>(rows, About(cones, ConeOptions()));
    rows = Joined<O>(rows, About(map, MapOptions()));
    return Joined<O>(rows, About(solve, LimitingOptions()));
  }());
  return kTable;
}

Status CheckOptions(const ParameterizeOptions& options) {
  if (Status s = ParameterizeOptionTable().Validate(options); !s.ok()) return s;
  if (options.cone_budget >= 0 && options.cones.empty()) {
    return Status::InvalidInput("a cone budget needs a heuristic: name it as `cones`, one of " +
                                Join(ConeHeuristics().Names()));
  }
  if (options.cone_budget < 0) return Status();
  return ParseConeHeuristic(options.cones, options.cone_budget).status().In("cone_budget");
}

}  // namespace cirque

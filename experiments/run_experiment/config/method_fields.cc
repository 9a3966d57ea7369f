#include "experiments/run_experiment/config/method_fields.h"

#include <glog/logging.h>

#include "cirque/angles/registry.h"
#include "cirque/core/text.h"
#include "cirque/energy/angle_objective.h"
#include "cirque/layout/map_objective.h"
#include "cirque/pipeline/cut_costs.h"
#include "cirque/solver/solver_strategy.h"

#include "experiments/run_experiment/config/scalars.h"

namespace cirque {
namespace {

struct Setter {
  const std::string& text;
  ParameterizeOptions* options;

  void operator()(std::string ParameterizeOptions::*member) const { options->*member = text; }
  void operator()(double ParameterizeOptions::*member) const {
    const std::optional<double> value = ParseNumber(text);
    CHECK(value) << text;
    options->*member = *value;
  }
  void operator()(int ParameterizeOptions::*member) const {
    const std::optional<long long> value = ParseInteger(text);
    CHECK(value) << text;
    options->*member = static_cast<int>(*value);
  }
};

}  // namespace

const std::vector<MethodField>& MethodFields() {
  using Options = ParameterizeOptions;
  static const std::vector<MethodField> fields = {
      {"triangulation",
       &Options::triangulation,
       "intrinsic Delaunay flips first, or the input's connectivity",
       0,
       0,
       {"delaunay", "input"}},
      {"angle_objective",
       &Options::angle_objective,
       "the objective of the angle fit",
       0,
       0,
       AngleObjectives().Names(),
       {"angle_fit"}},
      {"angle_solver",
       &Options::angle_solver,
       "the solver of the angle fit",
       0,
       0,
       AngleSolverNames(),
       {"angle_strategy"}},
      {"radii_solver",
       &Options::radii_solver,
       "the solver of the log radii",
       0,
       0,
       KnownStrategyNames(),
       {"strategy"}},
      {"layout",
       &Options::layout,
       "how the flat triangles are placed",
       0,
       0,
       {"directions", "least_squares"}},
      {"cones", &Options::cones, "the cone heuristic, NAME or NAME:KEY=VALUE,...", 0, 0, {}},
      {"cone_budget",
       &Options::cone_budget,
       "the most cones; -1: the heuristic's own default",
       -1,
       1e6,
       {}},
      {"cone_angles",
       &Options::cone_angles,
       "free, pi/2, pi/3, ranges or ranges:width=RADIANS",
       0,
       0,
       {}},
      {"refine_cones",
       &Options::refine_cones,
       "steps of the refinement of the cones' angles",
       0,
       1000,
       {}},
      {"refine_map",
       &Options::refine_map,
       "refines the finished map: none, " + Join(MapObjectives().Names()) +
           ", or NAME:KEY=VALUE,...",
       0,
       0,
       {}},
      {"seams",
       &Options::seams,
       "the two sides of a cut stay congruent, or the surface opened along it gets a free boundary",
       0,
       0,
       {"rigid", "free"}},
      {"cut_cost", &Options::cut_cost, "what the cut is short in", 0, 0, CutCostWords()},
      {"edge_costs",
       &Options::edge_costs,
       "file of factors on that: 'from to cost' a line",
       0,
       0,
       {}},
      {"epsilon", &Options::epsilon, "least corner and intersection angle [rad]", 1e-12, 1, {}},
      {"max_iterations", &Options::max_iterations, "limit of each solve", 1, 1e6, {}},
  };
  return fields;
}

void SetField(const MethodField& field, const std::string& text, ParameterizeOptions* options) {
  std::visit(Setter{text, options}, field.member);
}

nlohmann::json FieldValue(const MethodField& field, const ParameterizeOptions& options) {
  return std::visit([&](auto member) { return nlohmann::json(options.*member); }, field.member);
}

}  // namespace cirque

#include "experiments/remesh/settings.h"

#include <set>
#include <string>

#include "cirque/core/text.h"
#include "cirque/domains/map_options.h"
#include "cirque/remesh/curvature_density.h"

namespace cirque {
namespace {

constexpr char kProgram[] = "remesh";

const std::set<std::string>& OfLayouts() {
  static const std::set<std::string> kNames = {"layout",     "seams",       "cut_cost",
                                               "edge_costs", "refine_map",  "injective",
                                               "solve_at",   "least_charts"};
  return kNames;
}

const OptionTable<RemeshSettings>& SettingsTable() {
  using S = RemeshSettings;
  static const OptionTable<S> kTable(
      kProgram,
      {Option<S>(
           "density", &S::density,
           "a file, a number a line for each vertex of IN: of how many times as many vertices "
           "per area; or curvature, or curvature:KEY=VALUE,...: edges as long as the radius of "
           "curvature; keys " +
               Join(CurvatureSizingTable().Names()))
           .Unit(kFileUnit)
           .About("Mesh"),
       Option<S>("quads", &S::quads, "the same as --lattice=squares").About("Mesh"),
       Option<S>("correspondence", &S::correspondence,
                 "to write, a line a vertex of OUT: the face of IN that has it, three vertices of "
                 "that face and their weights")
           .Unit(kFileUnit)
           .About("Output"),
       Option<S>("report", &S::report,
                 ".json to write: the quality of the triangles, and distances between OUT and IN")
           .Unit(kFileUnit)
           .About("Output"),
       Option<S>("measure", &S::measure,
                 "OUT is there already, made by whatever program: it is only measured")
           .About("Output"),
       Option<S>("quiet", &S::quiet, "say nothing but what went wrong").About("Program")});
  return kTable;
}

}  // namespace

Manual RemeshManual() {
  Manual manual;
  manual.program = kProgram;
  manual.purpose = "meshes a surface anew with even triangles, by a conformal map of it";
  manual.usage = {{"--edge=L IN OUT", "IN by triangles with edges of about that length"},
                  {"--vertices=N IN OUT", "by about so many vertices"},
                  {"--quads --vertices=N IN OUT", "a closed surface by quadrilaterals"},
                  {"--measure IN OUT", "the quality of a mesh that is there already"}};
  manual.rules = {
      "Every vertex of OUT lies on IN, to rounding. Boundary loops, handles and components are "
      "those of IN. The map's cones are vertices of OUT. Nothing is laid out, and so there are no "
      "seams in it.",
      "Vertices and faces are counted from 1."};
  manual.statuses = {{"0", "done"},
                     {"1", "not converged"},
                     {"2", "bad input, or the machine failed"},
                     {"3", "there is no such map, as is proven"},
                     {"4", "the map exceeds what doubles hold"}};
  manual.first = {"edge",    "vertices", "quads",       "lattice",  "even",           "density",
                  "corners", "cones",    "cone_budget", "holonomy", "correspondence", "report",
                  "measure", "quiet",    "help",        "version"};
  manual.groups = {"Mesh", "Output", "Cones", "Solver", "Program"};
  return manual;
}

CommandLine RemeshFlags(RemeshSettings* settings) {
  CommandLine line;
  line.Add(RemeshOptionTable(), &settings->mesh);
  line.Add(SettingsTable(), settings);
  for (const Option<ParameterizeOptions>& option : ParameterizeOptionTable().options()) {
    if (OfLayouts().contains(option.info().name)) continue;
    line.Add({option.info(), [&option, settings](const std::string& text) {
                OptionInfo as_flag = option.info();
                as_flag.name = "--" + as_flag.name;
                const StatusOr<OptionValue> value = ParseValue(as_flag, text);
                return value.ok() ? option.Set(text, &settings->map) : value.status();
              }});
  }
  const Option<MeshOptions>& repair = *MeshOptionTable().Find("repair");
  line.Add({repair.info(), [&repair, settings](const std::string& text) {
              MeshOptions set;
              const Status status = repair.Set(text, &set);
              settings->repair = set.repair;
              return status;
            }});
  line.AddQuestions();
  return line;
}

Status CheckSettings(const RemeshSettings& settings) {
  const bool by_edge = settings.mesh.edge > 0, by_vertices = settings.mesh.vertices > 0;
  if (settings.measure && (by_edge || by_vertices || !settings.correspondence.empty())) {
    return Status::InvalidInput("--measure makes no mesh: leave out what says how it shall be");
  }
  if (!settings.measure && by_edge == by_vertices) {
    return Status::InvalidInput("give one of --edge=LENGTH and --vertices=NUMBER");
  }
  return CheckOptions(settings.map);
}

}  // namespace cirque

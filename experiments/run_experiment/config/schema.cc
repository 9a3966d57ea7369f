#include "experiments/run_experiment/config/schema.h"

#include <fmt/format.h>

#include "cirque/core/text.h"
#include "cirque/domains/domain.h"
#include "cirque/domains/map_options.h"
#include "cirque/metrics/measure_map.h"

#include "experiments/run_experiment/config/energy_methods.h"
#include "experiments/run_experiment/config/peer_programs.h"
#include "experiments/run_experiment/config/planned_run.h"
#include "experiments/run_experiment/config/quantities.h"

namespace cirque {
namespace {

FieldKind KindOf(OptionKind kind) {
  switch (kind) {
    case OptionKind::kBoolean:
      return FieldKind::kBoolean;
    case OptionKind::kInteger:
      return FieldKind::kInteger;
    case OptionKind::kNumber:
      return FieldKind::kNumber;
    case OptionKind::kText:
    case OptionKind::kIntegers:
      return FieldKind::kText;
  }
  return FieldKind::kText;
}

SchemaField ForMethod(const OptionInfo& option) {
  const std::string unit = option.unit.empty() ? "" : fmt::format(" [{}]", option.unit);
  return {.path = "methods." + option.name,
          .kind = KindOf(option.kind),
          .help = option.help + unit,
          .default_text = option.default_text,
          .matrix = true,
          .minimum = option.bounds.lower,
          .maximum = option.bounds.upper,
          .choices = option.words,
          .check = option.check,
          .former = option.former};
}

/// The entries of `methods`.
Schema MethodSchema() {
  Schema schema = {{.path = "methods.name", .help = "its name in tables", .required = true},
                   {.path = "methods.domain",
                    .help = "what surfaces are mapped to; vertices that a shape needs are chosen",
                    .default_text = MethodSpec().domain,
                    .matrix = true,
                    .choices = Domains().Names()},
                   {.path = "methods.exact",
                    .kind = FieldKind::kBoolean,
                    .help = "whether the exact map is made too, whose figures are called exact_...",
                    .default_text = "false",
                    .matrix = true}};
  const Schema of_energies = EnergyFields();
  schema.insert(schema.end(), of_energies.begin(), of_energies.end());
  for (const OptionInfo& option : ParameterizeOptionTable().Infos()) {
    schema.push_back(ForMethod(option));
  }
  return schema;
}

/// Which runs are made, within what limits, and what is kept of them.
Schema RunFields() {
  using enum FieldKind;
  return {
      {.path = "repeats",
       .kind = kInteger,
       .help = "how often every mesh meets every method",
       .default_text = "1",
       .minimum = 1,
       .maximum = 1000},
      {.path = "seeds",
       .kind = kInteger,
       .help = "generated meshes are made with each of these seeds: runs that differ by what is "
               "random, the places of the vertices",
       .list = true,
       .minimum = 0,
       .maximum = kMaxSeed},
      {.path = "include",
       .help = "makes only the runs named MESH/METHOD by one of these patterns (* ? [...])",
       .default_text = "*",
       .list = true},
      {.path = "exclude", .help = "leaves out the runs named by one of these", .list = true},
      {.path = "time_limit",
       .kind = kNumber,
       .help = "wall time [s] after which a run is ended; raised, it is made again",
       .default_text = "none",
       .minimum = 1e-3,
       .maximum = 1e7},
      {.path = "memory_limit",
       .kind = kNumber,
       .help = "resident memory [MiB] at which a run is ended; raised, it is made again",
       .default_text = "none",
       .minimum = 1,
       .maximum = 1e8},
      {.path = "keep_maps",
       .help = "writes maps/KEY.obj, the mesh with its map: true, false or names of runs as above",
       .default_text = "false",
       .list = true},
      {.path = "reference",
       .kind = kBoolean,
       .help = "whether every run also times one factorization of its mesh's cotangent Laplacian",
       .default_text = "false"},
      {.path = "against_refined",
       .kind = kBoolean,
       .help =
           "whether maps of disks to the plane, whose smooth map no generator knows, are also "
           "compared with that of the surface subdivided once more, as the mesh's `subdivision` "
           "says: refined_map_rms_error and refined_map_max_error, at the vertices that both have, "
           "after the best similarity. The run's time is that of both",
       .default_text = "false"},
      {.path = "measures",
       .help = "further figures of every map: columns of the results",
       .list = true,
       .choices = FigureNames()},
      {.path = "output",
       .help = "the folder of the results",
       .default_text = "results/runs/NAME-OF-THE-CONFIG"},
  };
}

std::map<std::string, std::string> FormerGroups() {
  std::map<std::string, std::string> former;
  for (const OptionInfo& option : ParameterizeOptionTable().Infos()) {
    for (const std::string& name : option.former) former[name] = option.name;
  }
  return former;
}

/// The entries of `figures`.
Schema FigureFields() {
  return {
      {.path = "figures.kind",
       .help = "points, lines through the medians of runs with equal x, or bars that count runs",
       .default_text = "scatter",
       .choices = {"scatter", "lines", "histogram"}},
      {.path = "figures.x",
       .help = "what is shown from left to right",
       .required = true,
       .choices = QuantityNames()},
      {.path = "figures.y",
       .help = "what is shown upwards; a histogram has none",
       .choices = QuantityNames()},
      {.path = "figures.by",
       .help = "the runs of one colour have this in common",
       .default_text = "method",
       .choices = GroupNames(),
       .former_choices = FormerGroups()},
      {.path = "figures.scale",
       .help = "of the axes: both linear, both logarithmic, or one of them",
       .default_text = "linear",
       .choices = {"linear", "log", "log_x", "log_y"}},
      {.path = "figures.title", .help = "above the figure", .default_text = "from x, y and by"},
  };
}

Schema MakeSchema() {
  using enum FieldKind;
  Schema schema = {
      {.path = "question", .help = "what the experiment asks, in one sentence", .required = true}};
  const auto add = [&](const Schema& fields) {
    schema.insert(schema.end(), fields.begin(), fields.end());
  };
  add({{.path = "meshes", .kind = kSections, .help = "the surfaces", .required = true}});
  add(MeshSchema());
  add({{.path = "methods",
        .kind = kSections,
        .help = "how each surface is parameterized",
        .required = true}});
  add(MethodSchema());
  add(PeerFields());
  add(RunFields());
  add({{.path = "figures",
        .kind = kSections,
        .help = "what the report draws of these runs, before the figures that it always has"}});
  add(FigureFields());
  return schema;
}

std::string Range(const SchemaField& field) {
  return fmt::format("{} from {} to {}",
                     field.kind == FieldKind::kInteger ? "a whole number" : "a number",
                     field.minimum, field.maximum);
}

}  // namespace

std::string SchemaField::Key() const { return path.substr(path.rfind('.') + 1); }

std::string_view SchemaField::Parent() const {
  const std::size_t dot = path.rfind('.');
  return std::string_view(path).substr(0, dot == std::string::npos ? 0 : dot);
}

const Schema& ConfigSchema() {
  static const Schema schema = MakeSchema();
  return schema;
}

std::vector<const SchemaField*> FieldsOf(const Schema& schema, const std::string& path) {
  std::vector<const SchemaField*> fields;
  for (const SchemaField& field : schema) {
    if (field.Parent() == path) fields.push_back(&field);
  }
  return fields;
}

std::string Expectation(const SchemaField& field) {
  switch (field.kind) {
    case FieldKind::kText:
      return field.choices.empty() ? "a text" : "one of " + Join(field.choices);
    case FieldKind::kInteger:
    case FieldKind::kNumber:
      return Range(field);
    case FieldKind::kBoolean:
      return "true or false";
    case FieldKind::kSections:
      return "a list of entries";
  }
  return {};
}

}  // namespace cirque

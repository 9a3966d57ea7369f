#include "experiments/run_experiment/schema.h"

#include <fmt/format.h>

#include "cirque/core/text.h"
#include "cirque/mesh/generators.h"
#include "cirque/metrics/measure_map.h"

#include "experiments/run_experiment/method_fields.h"

namespace cirque {
namespace {

constexpr double kMaxSeed = 4294967295.0;

FieldKind KindOf(const MethodField& field) {
  constexpr FieldKind kKinds[] = {FieldKind::kText, FieldKind::kNumber, FieldKind::kInteger};
  return kKinds[field.member.index()];
}

std::string DefaultOf(const MethodField& field) {
  const nlohmann::json value = FieldValue(field, ParameterizeOptions());
  return value.is_string() ? value.get<std::string>() : value.dump();
}

SchemaField ForMethod(const MethodField& field) {
  const bool is_text = KindOf(field) == FieldKind::kText;
  SchemaField row{.path = "methods." + field.name,
                  .kind = KindOf(field),
                  .help = field.help,
                  .default_text = DefaultOf(field),
                  .matrix = true,
                  .choices = field.choices};
  if (!is_text) {
    row.minimum = field.minimum;
    row.maximum = field.maximum;
  }
  return row;
}

/// Which runs are made, and within what limits.
Schema CellFields() {
  using enum FieldKind;
  return {
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
  };
}

Schema MakeSchema() {
  using enum FieldKind;
  const GeneratorOptions generator;
  Schema schema = {
      {.path = "question", .help = "what the experiment asks, in one sentence", .required = true},
      {.path = "meshes", .kind = kSections, .help = "the surfaces", .required = true},
      {.path = "meshes.file",
       .help = "a mesh file or a pattern such as ../meshes/*.obj",
       .one_of = "source"},
      {.path = "meshes.archive",
       .help = "an archive (tar.gz, zip, ...) or compressed file that holds the mesh",
       .one_of = "source",
       .brings = "member"},
      {.path = "meshes.member",
       .help = "the mesh file's name inside the archive",
       .beside = {"archive"}},
      {.path = "meshes.generator",
       .help = "the name of a mesh generator",
       .choices = MeshGenerators().Names(),
       .one_of = "source"},
      {.path = "meshes.triangles",
       .kind = kInteger,
       .help = "about how many the generator makes",
       .default_text = fmt::to_string(generator.triangles),
       .matrix = true,
       .minimum = 1,
       .maximum = 1e8,
       .beside = {"generator"}},
      {.path = "meshes.seed",
       .kind = kInteger,
       .help = "of the generator's irregular vertex positions",
       .default_text = fmt::to_string(generator.seed),
       .matrix = true,
       .minimum = 0,
       .maximum = kMaxSeed,
       .beside = {"generator"}},
      {.path = "meshes.boundary",
       .help = "its angles: free, or fixed to those of the generator's known conformal map",
       .default_text = "free",
       .matrix = true,
       .choices = {"free", "known_map"},
       .beside = {"generator"}},
      {.path = "meshes.name", .help = "its name in tables, if not the file's or the generator's"},
      {.path = "meshes.optional",
       .kind = kBoolean,
       .help = "whether the mesh is skipped where its file does not exist",
       .default_text = "false",
       .beside = {"file", "archive"}},
      {.path = "methods",
       .kind = kSections,
       .help = "how each surface is parameterized",
       .required = true},
      {.path = "methods.name", .help = "its name in tables", .required = true},
  };
  for (const MethodField& field : MethodFields()) schema.push_back(ForMethod(field));
  schema.push_back({.path = "repeats",
                    .kind = kInteger,
                    .help = "how often every mesh meets every method",
                    .default_text = "1",
                    .minimum = 1,
                    .maximum = 1000});
  const std::vector<SchemaField> cells = CellFields();
  schema.insert(schema.end(), cells.begin(), cells.end());
  schema.push_back({.path = "measures",
                    .help = "further figures of every map: columns of the results",
                    .list = true,
                    .choices = FigureNames()});
  schema.push_back({.path = "output",
                    .help = "the folder of the results",
                    .default_text = "results/runs/NAME-OF-THE-CONFIG"});
  return schema;
}

std::string Range(const SchemaField& field) {
  return fmt::format("{} from {} to {}",
                     field.kind == FieldKind::kInteger ? "a whole number" : "a number",
                     field.minimum, field.maximum);
}

}  // namespace

std::string SchemaField::Key() const { return path.substr(path.rfind('.') + 1); }

std::string SchemaField::Parent() const {
  const std::size_t dot = path.rfind('.');
  return dot == std::string::npos ? "" : path.substr(0, dot);
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

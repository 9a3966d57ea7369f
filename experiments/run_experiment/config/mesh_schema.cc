#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/text.h"
#include "cirque/domains/map_options.h"
#include "cirque/generators/generators.h"

#include "experiments/run_experiment/config/mesh_condition.h"
#include "experiments/run_experiment/config/mesh_sources.h"
#include "experiments/run_experiment/config/planned_run.h"
#include "experiments/run_experiment/config/remeshing.h"
#include "experiments/run_experiment/config/schema.h"

namespace cirque {
namespace {

constexpr double kMaxSubdivisions = 12;  // 16 million times as many triangles

/// Where they come from.
Schema FileFields() {
  return {
      {.path = "meshes.file",
       .help = "a mesh file or a pattern such as ../meshes/*.obj; $MESHES/ is the folder that the "
               "environment's CIRQUE_MESHES names, else meshes/",
       .one_of = "source"},
      {.path = "meshes.corpus",
       .help = "every mesh of a collection: " + Join(Corpora().Names()) +
               ", a folder and those in it, an archive, or a list (a .txt file with a path on "
               "every line)",
       .one_of = "source"},
      {.path = "meshes.archive",
       .help = "an archive (tar.gz, zip, ...) or compressed file that holds the mesh",
       .one_of = "source",
       .brings = "member"},
      {.path = "meshes.member",
       .help = "the mesh file's name inside the archive",
       .beside = {"archive"}},
      {.path = "meshes.where",
       .help = "only the meshes of which this holds, such as genus == 0 and triangles > 1000: "
               "comparisons of numbers with " +
               Join(FactNames()) + ", joined by and, or, not and parentheses",
       .check = [](const std::string& text) { return ParseMeshCondition(text).status(); },
       .beside = {"file", "corpus", "archive"}},
  };
}

/// What is asked of a generator.
Schema GeneratorFields() {
  using enum FieldKind;
  const GeneratorOptions generator;
  return {
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
  };
}

/// What is done to them before they are mapped.
Schema FinenessFields() {
  using enum FieldKind;
  const OptionInfo& repair = MeshOptionTable().Find("repair")->info();
  return {
      {.path = "meshes.repair",
       .help = "as the flag of circle_patterns: " + repair.help +
               ". Several components are mapped side by side",
       .default_text = MeshSpec().repair,
       .matrix = true,
       .check = repair.check},
      {.path = "meshes.subdivisions",
       .kind = kInteger,
       .help = "how often the mesh is subdivided",
       .default_text = "0",
       .matrix = true,
       .minimum = 0,
       .maximum = kMaxSubdivisions},
      {.path = "meshes.subdivision",
       .help =
           "how: triangles split into four at midpoints, which keeps the polyhedron, or towards a "
           "smooth surface",
       .default_text = MeshSpec().subdivision,
       .matrix = true,
       .choices = SubdivisionSchemes(),
       .beside = {"subdivisions"}},
      {.path = "meshes.decimate",
       .kind = kInteger,
       .help =
           "before that, edges are collapsed by error quadrics until about so many triangles are "
           "left; 0: none",
       .default_text = "0",
       .matrix = true,
       .minimum = 0,
       .maximum = 1e8},
  };
}

}  // namespace

Schema MeshSchema() {
  Schema schema;
  for (Schema fields : {FileFields(), GeneratorFields(), FinenessFields()}) {
    std::move(fields.begin(), fields.end(), std::back_inserter(schema));
  }
  schema.push_back(
      {.path = "meshes.name", .help = "its name in tables, if not the file's or the generator's"});
  schema.push_back({.path = "meshes.optional",
                    .kind = FieldKind::kBoolean,
                    .help = "whether the mesh is skipped where its file does not exist",
                    .default_text = "false",
                    .beside = {"file", "corpus", "archive"}});
  return schema;
}

}  // namespace cirque

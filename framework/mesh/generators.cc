#include "cirque/mesh/generators.h"

#include <fmt/format.h>

#include "cirque/mesh/generator_table.h"

namespace cirque {

const Registry<MeshGenerator>& MeshGenerators() {
  static const Registry<MeshGenerator> table(
      "mesh generator",
      {{"flat_delaunay_patch", FlatDelaunayPatch}, {"hexagonal_fan", HexagonalFan}});
  return table;
}

StatusOr<PolygonSoup> GenerateMesh(const std::string& name, const GeneratorOptions& options) {
  const auto generator = MeshGenerators().Find(name);
  if (!generator.ok()) return generator.status();
  if (options.triangles < 1) {
    return Status::InvalidInput(fmt::format("mesh generator '{}': {} triangles; ask for at least 1",
                                            name, options.triangles));
  }
  return (*generator)(options);
}

}  // namespace cirque

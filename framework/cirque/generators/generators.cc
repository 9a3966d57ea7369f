#include "cirque/generators/generators.h"

#include <algorithm>

#include <fmt/format.h>

namespace cirque {
namespace {

MeshGenerator AtLeast(Index min_triangles, PolygonSoup (*make)(const GeneratorOptions&)) {
  return [=](GeneratorOptions options) {
    options.triangles = std::max(options.triangles, min_triangles);
    return make(options);
  };
}

}  // namespace

const Registry<MeshGenerator>& MeshGenerators() {
  static const Registry<MeshGenerator> table(
      "mesh generator", {{"flat_delaunay_patch", AtLeast(kMinTriangles, FlatDelaunayPatch)},
                         {"bumpy_terrain", AtLeast(kMinTriangles, BumpyTerrain)},
                         {"spherical_cap", AtLeast(kMinTriangles, SphericalCap)},
                         {"hemisphere", AtLeast(kMinTriangles, Hemisphere)},
                         {"enneper_patch", AtLeast(kMinTriangles, EnneperPatch)},
                         {"capped_tube", AtLeast(kMinTriangles, CappedTube)},
                         {"long_capped_tube", AtLeast(kMinTriangles, LongCappedTube)},
                         {"hexagonal_fan", HexagonalFan},
                         {"annulus", AtLeast(kMinTriangles, Annulus)},
                         {"eccentric_annulus", AtLeast(kMinTriangles, EccentricAnnulus)},
                         {"plate_with_holes", AtLeast(kMinTrianglesWithHandles, PlateWithHoles)},
                         {"catenoid", AtLeast(kMinTriangles, Catenoid)},
                         {"sphere", AtLeast(kMinTriangles, Sphere)},
                         {"blob", AtLeast(kMinTriangles, Blob)},
                         {"torus", AtLeast(kMinTrianglesWithHandles, Torus)},
                         {"double_torus", AtLeast(kMinTrianglesWithHandles, DoubleTorus)}});
  return table;
}

StatusOr<PolygonSoup> GenerateMesh(const std::string& name, const GeneratorOptions& options) {
  const auto generator = MeshGenerators().Find(name);
  if (!generator.ok()) return generator.status();
  if (options.triangles < 1 || options.triangles > kMaxTriangles) {
    return Status::InvalidInput(fmt::format("mesh generator '{}': {} triangles; ask for at least 1",
                                            name, options.triangles));
  }
  return (*generator)(options);
}

}  // namespace cirque

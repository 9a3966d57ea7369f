#pragma once

#include <functional>
#include <map>
#include <string>

#include "cirque/core/registry.h"
#include "cirque/mesh/polygon_soup.h"

namespace cirque {

/// What a generator is asked for. Equal options give equal meshes on every machine.
struct GeneratorOptions {
  Index triangles = 2000;  ///< about how many
  unsigned seed = 1;       ///< of the irregular vertex positions
};

using MeshGenerator = std::function<PolygonSoup(const GeneratorOptions&)>;

/// The table of generators, one line an entry in generators.cc.
const Registry<MeshGenerator>& MeshGenerators();

}  // namespace cirque

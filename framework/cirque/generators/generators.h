#pragma once

#include <functional>
#include <string>

#include "cirque/core/registry.h"
#include "cirque/core/status.h"
#include "cirque/io/polygon_soup.h"

namespace cirque {

/// What a generator is asked for. Equal options give equal meshes: everything random comes from the
/// standard's own generator with our own mapping, every geometric decision is exact. (Between
/// machines the C library's sin, exp and log may differ in the last bit, and with them positions.)
struct GeneratorOptions {
  Index triangles = 2000;  ///< about how many
  unsigned seed = 1;       ///< of the irregular vertex positions
};

/// Makes a mesh that is manifold, connected, free of isolated vertices and oriented
/// counter-clockwise as seen from outside or above. The irregular ones have within 10 % the number
/// of triangles asked for, from the minimum below up; smaller numbers give the minimum.
/// Vertices are numbered as the faces first name them.
using MeshGenerator = std::function<PolygonSoup(const GeneratorOptions&)>;

/// The least number of triangles of every generator: disks, rings and spheres; closed surfaces with
/// handles.
inline constexpr Index kMinTriangles = 20, kMinTrianglesWithHandles = 400;

/// The most that GenerateMesh makes: 32-bit halfedge numbers hold a little more.
inline constexpr Index kMaxTriangles = 500'000'000;

/// The table of generators, one line an entry in generators.cc; generator_table.h describes each.
const Registry<MeshGenerator>& MeshGenerators();

/// The mesh of the generator of that name. Errors (invalid input): unknown name (the known ones are
/// listed), a number of triangles below 1 or above kMaxTriangles.
StatusOr<PolygonSoup> GenerateMesh(const std::string& name, const GeneratorOptions& options);

}  // namespace cirque

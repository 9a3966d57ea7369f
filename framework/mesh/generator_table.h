#pragma once

#include "cirque/mesh/generators.h"

/// The generators that MeshGenerators() registers. V - E + F is the Euler characteristic; "loops"
/// are boundary loops. Conformal maps named here are those of known_maps.h.
namespace cirque {

/// The square [-1, 1]^2 at z = 0, vertices closer together near (0.4, 0.3) (edge lengths 1 : 3),
/// exactly Delaunay. V - E + F = 1, one loop. Conformal map: the identity.
PolygonSoup FlatDelaunayPatch(const GeneratorOptions& options);

/// The equilateral triangulation of a regular hexagon of k rings with edges of length 1: 6 k^2
/// triangles, k the number of rings that comes nearest to what is asked for (at least 1); the seed
/// is ignored. V - E + F = 1, one loop. Conformal map: the identity.
PolygonSoup HexagonalFan(const GeneratorOptions& options);

}  // namespace cirque

#pragma once

#include <vector>

#include "cirque/core/types.h"
#include "cirque/mesh/gluing.h"

namespace cirque {

/// Which triangles to turn around so that neighbours agree.
struct Orientation {
  std::vector<bool> turn;   ///< F: the minority of each piece of the surface that hangs together
  Index one_sided = kNone;  ///< a halfedge at which no choice agrees: the surface is one-sided
};

/// Follows the glued edges from triangle to triangle.
Orientation OrientTriangles(const std::vector<Index>& triangles, const Gluing& gluing);

/// Turns the triangles around: their second and third corners change places, and `mate` follows.
void TurnTriangles(const std::vector<bool>& turn, std::vector<Index>* triangles,
                   std::vector<Index>* mate);

}  // namespace cirque

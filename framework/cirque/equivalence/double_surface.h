#pragma once

#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// A surface and its mirror image, glued along the boundary: a closed surface. Face f of the
/// surface is face f of the double, with the same halfedges and edges; its mirror image is face
/// F + f, whose corners come in the opposite order. Vertices of the boundary keep their numbers and
/// are their own images; the images of the others follow behind.
struct DoubledSurface {
  Triangulation triangulation;
  EdgeLengths lengths;
  std::vector<Index> original;  ///< of the double's vertices: the one that it is or mirrors
};

DoubledSurface DoubleSurface(const Triangulation& triangulation, const EdgeLengths& lengths);

}  // namespace cirque

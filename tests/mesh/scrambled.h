#pragma once

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"

namespace cirque::testing {

struct IntrinsicMesh {
  Triangulation triangulation;
  EdgeLengths lengths;
};

/// The same metric after `flips` flips of randomly chosen edges that can be flipped.
IntrinsicMesh Scramble(const IntrinsicMesh& mesh, int flips, unsigned seed);

/// The flat torus of the lattice spanned by u and v, two triangles on a single vertex.
IntrinsicMesh LatticeTorus(const Eigen::Vector2d& u, const Eigen::Vector2d& v);

/// The flat torus of periods 2 x 2 with about n random vertices, exactly Delaunay.
IntrinsicMesh PeriodicPatch(int n, unsigned seed);

}  // namespace cirque::testing

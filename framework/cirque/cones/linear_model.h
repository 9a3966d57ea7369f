#pragma once

#include <Eigen/Core>

#include "cirque/intrinsic/intrinsic_surface.h"

namespace cirque {

/// Of every edge half the sum of the cotangents of its opposite angles (of one, on the boundary): the
/// weights of the cotangent Laplacian, E. None is below 1e-8 or above 1e8, so that the Laplacian of
/// any triangles is positive; of intrinsic Delaunay connectivity none is negative in the first place.
Eigen::VectorXd CotangentWeights(const IntrinsicSurface& surface);

/// A third of each face's area to each of its corners, V, of total 1; at least a millionth of their
/// mean.
Eigen::VectorXd VertexAreas(const IntrinsicSurface& surface);

}  // namespace cirque

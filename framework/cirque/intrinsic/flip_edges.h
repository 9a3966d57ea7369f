#pragma once

#include <functional>
#include <vector>

#include "cirque/core/metric.h"
#include "cirque/intrinsic/flip_complex.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"

namespace cirque {

/// Whether the flip of h, which has just been done, is to stay.
using KeepFlip = std::function<bool(const FlipComplex& flipped, Index h)>;

/// `from` after flips of those of the edges (of its triangulation, in this order) that may be flipped:
/// inner ones between two different faces whose unfolded quadrilateral is strictly convex, that share
/// no face with one flipped before, and that leave their ends corners enough for the targets
/// (Theta_v < corners * pi), as far as `keep`, which sees the complex after the flip of h, agrees.
/// Lengths are those of the same metric; flips and edge_of_input go on. The edges need not violate
/// Delaunay: who flips them has reasons of their own.
IntrinsicTriangulation FlipEdges(const IntrinsicTriangulation& from,
                                 const std::vector<Index>& edges, const ConeTargets& targets,
                                 const KeepFlip& keep);

}  // namespace cirque

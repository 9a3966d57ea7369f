#pragma once

#include <vector>

#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/flip_complex.h"
#include "cirque/intrinsic/normal_coordinates.h"
#include "cirque/intrinsic/triple_flip_complex.h"

namespace cirque {

/// Flips edges of a Euclidean metric until edges of an input triangulation that are straight lines
/// in it are edges again. Edges that one of them crosses are turned where the two faces at them unfold
/// to a strictly convex quadrilateral: first those whose other diagonal it crosses no more, and where
/// none is such, any (after S. W. Sloan, "A fast algorithm for generating constrained Delaunay
/// triangulations", Computers & Structures 47, 1993).
///
/// `edges` (E of the input): which, no two of them crossing. `normal` says where the input's edges
/// run on `metric`, both in the same state; they are flipped together and `flips` gets the halfedges
/// as FlipComplex::Flip takes them. False: a line is none, or rounding leaves no such quadrilateral;
/// all three then are somewhere on the way.
bool RestoreEdges(const Triangulation& input, const std::vector<bool>& edges,
                  NormalCoordinates* normal, FlipComplex* metric, std::vector<Index>* flips);
bool RestoreEdges(const Triangulation& input, const std::vector<bool>& edges,
                  NormalCoordinates* normal, TripleFlipComplex* metric, std::vector<Index>* flips);

}  // namespace cirque

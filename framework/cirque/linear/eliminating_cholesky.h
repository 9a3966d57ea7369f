#pragma once

#include <memory>

#include "cirque/linear/sparse_cholesky.h"

namespace cirque {

/// Eliminates by hand what is diagonal, and leaves the rest (the Schur complement) to `inner`:
/// unknowns with at most three neighbours, no two of them adjacent, chosen greedily in their order.
/// Of the normal matrix of an angle fit those are the triangles without an active edge, which
/// leaves little more than a V x V matrix; of a dual Laplacian nearly half of the triangles.
/// Orderings find the same eliminations, but after having looked at three times as many unknowns.
std::unique_ptr<SparseCholesky> MakeEliminatingCholesky(std::unique_ptr<SparseCholesky> inner);

}  // namespace cirque

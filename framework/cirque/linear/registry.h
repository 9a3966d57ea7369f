#pragma once

#include <functional>
#include <memory>
#include <string>

#include "cirque/core/registry.h"
#include "cirque/linear/sparse_cholesky.h"

namespace cirque {

using SparseCholeskyFactory = std::function<std::unique_ptr<SparseCholesky>()>;

/// `cholmod` (when built with it) and `eigen`; the first is the default.
const Registry<SparseCholeskyFactory>& LinearSolvers();

/// The linear solver of that name behind the elimination of what is diagonal
/// (MakeEliminatingCholesky); empty: the first of the table. @pre the name is known.
std::unique_ptr<SparseCholesky> MakeCholesky(const std::string& name = "");

/// LL' by Eigen with AMD ordering: no dependency beyond Eigen, slower than CHOLMOD on large meshes.
std::unique_ptr<SparseCholesky> MakeEigenCholesky();

/// LL' by SuiteSparse's CHOLMOD with AMD ordering, simplicial or supernodal by the work a factor
/// entry takes. Only where the library is built with it.
std::unique_ptr<SparseCholesky> MakeCholmodCholesky();

/// Eliminates by hand what is diagonal, and leaves the rest (the Schur complement) to `inner`:
/// unknowns with at most three neighbours, no two of them adjacent, chosen greedily in their order.
/// Of the normal matrix of an angle fit those are the triangles without an active edge, which
/// leaves little more than a V x V matrix; of a dual Laplacian nearly half of the triangles.
/// Orderings find the same eliminations, but after having looked at three times as many unknowns.
std::unique_ptr<SparseCholesky> MakeEliminatingCholesky(std::unique_ptr<SparseCholesky> inner);

}  // namespace cirque

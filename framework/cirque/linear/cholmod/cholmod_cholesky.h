#pragma once

#include <memory>

#include "cirque/linear/sparse_cholesky.h"

namespace cirque {

/// LL' by SuiteSparse's CHOLMOD with AMD ordering, simplicial or supernodal by the work a factor
/// entry takes.
std::unique_ptr<SparseCholesky> MakeCholmodCholesky();

}  // namespace cirque

#pragma once

#include <memory>

#include "cirque/linear/sparse_cholesky.h"

namespace cirque {

/// LL' by Eigen with AMD ordering: no dependency beyond Eigen, slower than CHOLMOD on large meshes.
std::unique_ptr<SparseCholesky> MakeEigenCholesky();

}  // namespace cirque

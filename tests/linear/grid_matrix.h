#pragma once

#include "cirque/energy/energy.h"

namespace cirque {

/// The Laplacian of a grid of side x side points whose edges weigh 1 + spread * noise in [0, 1),
/// plus a multiple of the identity: its lower triangle.
SparseMatrix GridMatrix(int side, double diagonal, double spread = 0);

}  // namespace cirque

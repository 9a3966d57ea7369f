#pragma once

#include <optional>

#include <Eigen/Core>

#include "cirque/math/lattice.h"

namespace cirque {

/// Lattices that a seamless map may have: unit squares, turned by multiples of pi/2 across seams
/// (Gaussian integers), or unit triangles, by multiples of pi/3 (Eisenstein integers).
enum class LatticeKind { kSquares, kTriangles };

/// The rotations about a point of a lattice: 4 or 6.
int OrderOf(LatticeKind kind);

/// The lattice of that order; none: no lattice's.
std::optional<LatticeKind> LatticeOfOrder(int order);

/// Its periods: 1, and the one a rotation further, i or e^(i pi/3).
Lattice PeriodsOf(LatticeKind kind);

/// The nearest point of a lattice.
Eigen::Vector2d NearestInLattice(LatticeKind kind, const Eigen::Vector2d& point);

}  // namespace cirque

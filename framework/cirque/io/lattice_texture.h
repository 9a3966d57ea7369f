#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/math/unit_lattice.h"

namespace cirque {

/// Where a map that repeats by a lattice has an angle other than 2 pi: the lattice's pattern has more or fewer
/// sectors there than in the plane.
struct ConeMark {
  Eigen::Vector3d position;
  double angle_sum;  ///< [rad]
};

/// What shows a map in units of a lattice, whose seams take the lattice to itself.
struct LatticeTexture {
  LatticeKind kind = LatticeKind::kSquares;
  std::vector<ConeMark> cones;
};

}  // namespace cirque

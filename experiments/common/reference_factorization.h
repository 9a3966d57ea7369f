#pragma once

#include "cirque/mesh/surface.h"

namespace cirque {

/// What any conformal map of a mesh costs at least, to compare whole programs by across machines.
struct ReferenceFactorization {
  double seconds = 0;      ///< wall time
  double cpu_seconds = 0;  ///< of this thread: what other programs take of the machine is not in it
};

/// One analysis and one factorization of the V x V cotangent Laplacian plus 1e-8 on the diagonal:
/// CHOLMOD with AMD's ordering on one core (Eigen's LL' in a build without CHOLMOD). Nothing of
/// what makes our own factorizations faster is in it, so that this yardstick stays what it is.
/// The fastest of `repeats`, by CPU time, counts: the first pays for the memory.
/// @pre a surface of the preflight: no edge of length 0; repeats >= 1.
ReferenceFactorization TimeReferenceFactorization(const Surface& surface, int repeats);

/// The same of the F x F dual Laplacian with weights 1, the least that a circle pattern costs.
ReferenceFactorization TimeDualFactorization(const Triangulation& triangulation);

}  // namespace cirque

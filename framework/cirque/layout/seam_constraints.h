#pragma once

#include <array>
#include <complex>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/triangulation.h"
#include "cirque/layout/seams.h"

namespace cirque {

/// That the two sides of every edge on a seam differ by the seam's rotation: of four vertices of
/// the opened surface, (z_0 - z_1) - e^{i rotation} (z_2 - z_3) = 0.
struct SeamConstraint {
  std::array<Index, 4> vertex;  ///< right tip, right tail, left tip, left tail
  std::array<std::complex<double>, 4> factor;
  Index left_face, right_face;

  /// The left side of the equation at z.
  std::complex<double> operator()(const Eigen::VectorXcd& z) const;
};

/// One for every edge of the seams. `open`: the surface cut open, of the same halfedges.
std::vector<SeamConstraint> SeamConstraints(const Triangulation& triangulation,
                                            const Triangulation& open,
                                            const std::vector<Seam>& seams);

}  // namespace cirque

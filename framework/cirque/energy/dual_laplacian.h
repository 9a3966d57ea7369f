#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/triangulation.h"
#include "cirque/energy/energy.h"

namespace cirque {

/// The weighted Laplacian of the dual graph: sum over interior edges of w (x_i - x_j)^2 / 2, i and
/// j the faces beside the edge. Its pattern, that of every system for the log radii, is laid out
/// once. A face glued to itself adds nothing.
class DualLaplacian {
 public:
  explicit DualLaplacian(const Triangulation& triangulation);

  /// The lower triangle; weights per halfedge (3F), that of an edge at both of its halfedges, any
  /// on the boundary.
  void Assemble(const Eigen::VectorXd& weight, SparseMatrix* lower) const;

  /// The pattern, with zeros as values.
  const SparseMatrix& pattern() const { return pattern_; }

 private:
  SparseMatrix pattern_;
  std::vector<int> slot_;  ///< per halfedge: of the edge's entry in its own face's column, kNone
                           ///< when that stands in the other's column or there is none
  std::vector<bool> couples_;  ///< per halfedge: whether another face is across
};

}  // namespace cirque

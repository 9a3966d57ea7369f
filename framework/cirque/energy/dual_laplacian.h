#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/triangulation.h"
#include "cirque/energy/energy.h"

namespace cirque {

/// Collects the edges of a weighted graph Laplacian.
class LaplacianAssembler {
 public:
  LaplacianAssembler(int num_nodes, std::size_t num_edges) : num_nodes_(num_nodes) {
    edges_.reserve(num_edges);
  }

  /// Adds w (x_i - x_j)^2 / 2 to the quadratic form. A loop (i == j) adds nothing.
  void Add(int i, int j, double weight) {
    if (i != j) edges_.push_back({i, j, weight});
  }

  /// The lower triangle; every diagonal entry is stored. The pattern depends on the edges alone.
  void Assemble(SparseMatrix* lower) const;

 private:
  struct Edge {
    int i, j;
    double weight;
  };

  int num_nodes_;
  std::vector<Edge> edges_;
};

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

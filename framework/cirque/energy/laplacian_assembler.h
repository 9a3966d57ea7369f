#pragma once

#include <cstddef>
#include <vector>

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

}  // namespace cirque

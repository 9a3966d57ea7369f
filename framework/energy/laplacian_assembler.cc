#include "cirque/energy/laplacian_assembler.h"

#include <algorithm>

namespace cirque {

LaplacianAssembler::LaplacianAssembler(int num_nodes, std::size_t num_edges)
    : num_nodes_(num_nodes) {
  entries_.reserve(num_nodes + 3 * num_edges);
  for (int i = 0; i < num_nodes; ++i) entries_.emplace_back(i, i, 0.0);
}

void LaplacianAssembler::Add(int i, int j, double weight) {
  if (i == j) return;
  entries_.emplace_back(i, i, weight);
  entries_.emplace_back(j, j, weight);
  entries_.emplace_back(std::max(i, j), std::min(i, j), -weight);
}

void LaplacianAssembler::Assemble(SparseMatrix* lower) const {
  lower->resize(num_nodes_, num_nodes_);
  lower->setFromTriplets(entries_.begin(), entries_.end());
}

}  // namespace cirque

#include "cirque/energy/laplacian_assembler.h"

#include <algorithm>

#include "cirque/energy/assemble_lower.h"

namespace cirque {

void LaplacianAssembler::Assemble(SparseMatrix* lower) const {
  AssembleLower(
      num_nodes_,
      [&](const auto& add) {
        for (int i = 0; i < num_nodes_; ++i) add(i, i, 0.0);
        for (const auto& [i, j, weight] : edges_) {
          add(i, i, weight);
          add(j, j, weight);
          add(std::max(i, j), std::min(i, j), -weight);
        }
      },
      lower);
}

}  // namespace cirque

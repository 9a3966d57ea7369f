#include "cirque/energy/edge_block_assembler.h"

#include <array>

namespace cirque {

EdgeBlockAssembler::EdgeBlockAssembler(const AngleConstraints& constraints)
    : constraints_(constraints) {
  const int rows = constraints.num_rows();
  entries_.reserve(rows + 3 * constraints.triangulation().num_halfedges());
  for (int row = 0; row < rows; ++row) AddToDiagonal(row, 0.0);
}

void EdgeBlockAssembler::Add(Index h, Index g, double weight) {
  if (weight == 0) return;
  const std::array<int, 2> of_h = {Triangulation::Face(h), constraints_.VertexRow(h)};
  const std::array<int, 2> of_g = {Triangulation::Face(g), constraints_.VertexRow(g)};
  for (const int i : of_h) {
    for (const int j : of_g) {
      if (i != kNone && j != kNone && i >= j) entries_.emplace_back(i, j, weight);
    }
  }
}

void EdgeBlockAssembler::Assemble(SparseMatrix* lower) const {
  lower->resize(constraints_.num_rows(), constraints_.num_rows());
  lower->setFromTriplets(entries_.begin(), entries_.end());
}

}  // namespace cirque

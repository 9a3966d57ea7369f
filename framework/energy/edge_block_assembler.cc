#include "cirque/energy/edge_block_assembler.h"

#include <array>

#include "cirque/energy/assemble_lower.h"

namespace cirque {

EdgeBlockAssembler::EdgeBlockAssembler(const AngleConstraints& constraints)
    : constraints_(constraints), diagonal_(constraints.num_rows(), 0.0) {
  blocks_.reserve(constraints.triangulation().num_halfedges());
}

void EdgeBlockAssembler::Assemble(SparseMatrix* lower) const {
  const auto rows_of = [&](Index h) -> std::array<int, 2> {
    return {Triangulation::Face(h), constraints_.VertexRow(h)};
  };
  AssembleLower(
      constraints_.num_rows(),
      [&](const auto& add) {
        for (int row = 0; row < constraints_.num_rows(); ++row) add(row, row, diagonal_[row]);
        for (const auto& [h, g, weight] : blocks_) {
          for (const int i : rows_of(h)) {
            for (const int j : rows_of(g)) {
              if (i != kNone && j != kNone && i >= j) add(i, j, weight);
            }
          }
        }
      },
      lower);
}

}  // namespace cirque

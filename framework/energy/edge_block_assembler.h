#pragma once

#include <vector>

#include "cirque/energy/angle_constraints.h"
#include "cirque/energy/energy.h"

namespace cirque {

/// Collects A D A' for the A of angle constraints and a symmetric D over corners: the normal matrix
/// of every solve of an angle fit.
class EdgeBlockAssembler {
 public:
  explicit EdgeBlockAssembler(const AngleConstraints& constraints);

  /// Adds to D_hg (and, for h != g, must be called once more for D_gh). A zero adds no entries.
  void Add(Index h, Index g, double weight) {
    if (weight != 0) blocks_.push_back({h, g, weight});
  }

  /// Adds to a diagonal entry of the matrix itself.
  void AddToDiagonal(int row, double weight) { diagonal_[row] += weight; }

  /// The lower triangle; every diagonal entry is stored.
  void Assemble(SparseMatrix* lower) const;

 private:
  struct Block {
    Index h, g;
    double weight;
  };

  const AngleConstraints& constraints_;
  std::vector<Block> blocks_;
  std::vector<double> diagonal_;
};

}  // namespace cirque

#include "tests/linear/grid_matrix.h"

#include <algorithm>
#include <vector>

namespace cirque {

SparseMatrix GridMatrix(int side, double diagonal, double spread) {
  std::vector<Eigen::Triplet<double>> entries;
  unsigned state = 1;
  const auto couple = [&](int i, int j) {
    state = state * 1664525u + 1013904223u;
    const double weight = 1 + spread * state / 4294967296.0;
    entries.emplace_back(i, i, weight);
    entries.emplace_back(j, j, weight);
    entries.emplace_back(std::max(i, j), std::min(i, j), -weight);
  };
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      entries.emplace_back(y * side + x, y * side + x, diagonal);
      if (x > 0) couple(y * side + x, y * side + x - 1);
      if (y > 0) couple(y * side + x, y * side + x - side);
    }
  }
  SparseMatrix lower(side * side, side * side);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

}  // namespace cirque

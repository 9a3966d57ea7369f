#pragma once

#include "cirque/energy/energy.h"

namespace cirque {

/// Calls visit(i, j, p) for the entries below the diagonal of a symmetric matrix that is given by
/// its compressed lower triangle, each column beginning with its diagonal entry: row, column and
/// position among the values.
template <class Visit>
void ForEachOffDiagonal(const SparseMatrix& lower, const Visit& visit) {
  for (int j = 0; j < lower.cols(); ++j) {
    for (int p = lower.outerIndexPtr()[j] + 1; p < lower.outerIndexPtr()[j + 1]; ++p) {
      visit(lower.innerIndexPtr()[p], j, p);
    }
  }
}

/// Its diagonal.
inline Eigen::VectorXd Diagonal(const SparseMatrix& lower) {
  Eigen::VectorXd diagonal(lower.cols());
  for (int j = 0; j < lower.cols(); ++j) {
    diagonal[j] = lower.valuePtr()[lower.outerIndexPtr()[j]];
  }
  return diagonal;
}

}  // namespace cirque

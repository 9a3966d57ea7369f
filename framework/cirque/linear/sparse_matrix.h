#pragma once

#include <Eigen/SparseCore>

#include "cirque/core/parallel.h"

namespace cirque {

/// A symmetric matrix by its lower triangle, compressed by columns. The functions below take those
/// whose columns each begin with the diagonal entry.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

/// Entry (j, j).
inline double DiagonalEntry(const SparseMatrix& lower, int j) {
  return lower.valuePtr()[lower.outerIndexPtr()[j]];
}

/// The same, to be changed.
inline double& DiagonalEntry(SparseMatrix* lower, int j) {
  return lower->valuePtr()[lower->outerIndexPtr()[j]];
}

/// All of them, n.
inline Eigen::VectorXd Diagonal(const SparseMatrix& lower) {
  Eigen::VectorXd diagonal(lower.cols());
  ParallelFor(static_cast<int>(lower.cols()),
              [&](int j) { diagonal[j] = DiagonalEntry(lower, j); });
  return diagonal;
}

/// Calls visit(i, p) for the entries of column j below the diagonal: row and position among the
/// values.
template <class Visit>
void ForEachBelowDiagonal(const SparseMatrix& lower, int j, const Visit& visit) {
  for (int p = lower.outerIndexPtr()[j] + 1; p < lower.outerIndexPtr()[j + 1]; ++p) {
    visit(lower.innerIndexPtr()[p], p);
  }
}

/// Calls visit(i, j, p) for those of all columns.
template <class Visit>
void ForEachOffDiagonal(const SparseMatrix& lower, const Visit& visit) {
  for (int j = 0; j < lower.cols(); ++j) {
    ForEachBelowDiagonal(lower, j, [&](int i, int p) { visit(i, j, p); });
  }
}

}  // namespace cirque

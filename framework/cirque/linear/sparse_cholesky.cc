#include "cirque/linear/sparse_cholesky.h"

#include <algorithm>

namespace cirque {

bool SparseCholesky::Factorize(const SparseMatrix& lower) {
  if (!SamePatternAsBefore(lower)) {
    Reserve(static_cast<int>(lower.cols()));
    if (!AnalyzeAnew(lower)) return false;
  }
  ++factorizations_;
  return FactorizeNumerically(lower);
}

void SparseCholesky::SolveTogether(const Eigen::MatrixXd& b, Eigen::MatrixXd* x) {
  x->resize(b.rows(), b.cols());
  for (Eigen::Index c = 0; c < b.cols(); ++c) x->col(c) = Solve(b.col(c));
}

bool SparseCholesky::Prepare(const SparseMatrix& lower) {
  return SamePatternAsBefore(lower) || AnalyzeAnew(lower);
}

bool SparseCholesky::AnalyzeAnew(const SparseMatrix& lower) {
  ++symbolic_analyses_;
  column_starts_.assign(lower.outerIndexPtr(), lower.outerIndexPtr() + lower.cols() + 1);
  row_indices_.assign(lower.innerIndexPtr(), lower.innerIndexPtr() + lower.nonZeros());
  if (Analyze(lower)) return true;
  column_starts_.clear();
  return false;
}

bool SparseCholesky::SamePatternAsBefore(const SparseMatrix& lower) const {
  return static_cast<int>(column_starts_.size()) == lower.cols() + 1 &&
         static_cast<int>(row_indices_.size()) == lower.nonZeros() &&
         std::equal(column_starts_.begin(), column_starts_.end(), lower.outerIndexPtr()) &&
         std::equal(row_indices_.begin(), row_indices_.end(), lower.innerIndexPtr());
}

}  // namespace cirque

#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "cirque/linear/conjugate_gradients.h"
#include "cirque/linear/sparse_matrix.h"

namespace cirque {

/// Makes the factor of one matrix a good preconditioner for another that differs from it strongly
/// in a few rows, as the normal matrices of an angle fit do where edges have become active: sweeps
/// of Gauss-Seidel over those rows and what is near them, forwards before the factor is applied and
/// backwards after it (a multiplicative Schwarz method; Saad, Iterative methods, 14.3). Conjugate
/// gradients would take several iterations for every place where a few rows changed.
class PatchSmoother {
 public:
  /// For `lower`, when a factor of the matrix with this diagonal is at hand. Has no rows, and does
  /// nothing, where no diagonal entry changed much or so many did that local work would not help.
  PatchSmoother(const SparseMatrix& lower, const Eigen::VectorXd& diagonal_before);

  /// x approximates A^-1 b, symmetric and positive definite when `solve`, the factor's, is.
  void Apply(const Eigen::VectorXd& b, const Preconditioner& solve, Eigen::VectorXd* x);

  /// The two halves of Apply, for a solve between them by others: from *swept = 0 and *left = b,
  /// what the sweeps give and what they leave; then the sweeps back from x = swept + the solve's.
  void SweepForward(const Eigen::VectorXd& b, Eigen::VectorXd* swept, Eigen::VectorXd* left) const;
  void SweepBackward(const Eigen::VectorXd& b, Eigen::VectorXd* x) const;

  /// Apply() with that solve, as long as this lives.
  Preconditioner Around(Preconditioner solve);

  int num_rows() const { return static_cast<int>(rows_.size()); }

 private:
  struct Entry {
    int column;
    double value;
  };

  void CollectRows(const SparseMatrix& lower, const std::vector<char>& chosen);

  /// Calls body(begin, end) for pieces of the rows that are not coupled, at once.
  void ForEachPiece(const std::function<void(int begin, int end)>& body) const;

  /// Solves the k-th row for its own unknown.
  void Relax(int k, const Eigen::VectorXd& b, Eigen::VectorXd* x) const;

  std::vector<int> rows_;   ///< piece by piece, increasing in each
  std::vector<int> piece_;  ///< where each begins, and the last ends
  std::vector<int> first_;  ///< per row, where its entries off the diagonal begin
  std::vector<Entry> entries_;
  std::vector<double> diagonal_;
  Eigen::VectorXd near_, left_;  ///< what the first sweeps give, 0 beyond the rows; what they leave
};

}  // namespace cirque

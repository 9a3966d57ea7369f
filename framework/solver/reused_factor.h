#pragma once

#include <memory>
#include <string>

#include "cirque/core/solve_summary.h"
#include "cirque/solver/sparse_cholesky.h"

namespace cirque {

/// Solves systems whose matrices change little from one to the next: by conjugate gradients,
/// preconditioned with the last factor, and with a factor of their own when those take longer than
/// factoring anew would.
class ReusedFactor {
 public:
  /// `max_cg_iterations`: of a system before its matrix is factored. A triangular solve on the dual
  /// graph of a mesh costs a fifteenth to a twentieth of analysis and factorization, whatever the
  /// size.
  ReusedFactor(std::unique_ptr<SparseCholesky> cholesky, int max_cg_iterations)
      : cholesky_(std::move(cholesky)), max_cg_iterations_(max_cg_iterations) {}

  /// Analyses the pattern ahead of the first factorization.
  void Prepare(const SparseMatrix& lower) { cholesky_->Prepare(lower); }

  /// x with |A x - b| <= tolerance |b|, or as near as A's own factor comes. Counts and times what
  /// it does in `summary`. False when A is not positive definite in floating point.
  bool Solve(const SparseMatrix& lower, const Eigen::VectorXd& right_side, double tolerance,
             Eigen::VectorXd* x, SolveSummary* summary);

 private:
  bool IterateOnFactor(const SparseMatrix& lower, const Eigen::VectorXd& right_side,
                       double tolerance, Eigen::VectorXd* x, SolveSummary* summary);
  bool Factorize(const SparseMatrix& lower, SolveSummary* summary);

  std::unique_ptr<SparseCholesky> cholesky_;
  int max_cg_iterations_;
  bool has_factor_ = false;
};

}  // namespace cirque

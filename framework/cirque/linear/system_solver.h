#pragma once

#include <string>

#include "cirque/core/solve_summary.h"
#include "cirque/linear/sparse_matrix.h"

namespace cirque {

/// How exactly a system is to be solved: |A x - b| relative to |b|.
struct SolveAccuracy {
  double tolerance;   ///< of this system
  double goal = 0.1;  ///< of the systems still to come together, when this is one step of many
};

/// Solves systems whose matrices, symmetric and positive definite, change little from one to the
/// next: what it has made for one (a factor, a multigrid hierarchy) serves the next.
class SystemSolver {
 public:
  virtual ~SystemSolver() = default;

  /// Whether Prepare has a use for the pattern.
  virtual bool WantsPattern() const { return false; }

  /// Does ahead of the first system what its pattern alone allows; its values may be any.
  virtual void Prepare(const SparseMatrix& lower) { static_cast<void>(lower); }

  /// x with |A x - b| <= tolerance |b|, or as near as A's own factor comes; A by its lower
  /// triangle. Counts and times what it does in `summary`. False when A is not positive definite in
  /// floating point.
  virtual bool Solve(const SparseMatrix& lower, const Eigen::VectorXd& right_side,
                     const SolveAccuracy& accuracy, Eigen::VectorXd* x, SolveSummary* summary) = 0;

  /// What a reader of the summary should know of how the systems were solved; mostly empty.
  virtual std::string Remark() const { return ""; }
};

}  // namespace cirque

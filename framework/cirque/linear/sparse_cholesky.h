#pragma once

#include <vector>

#include "cirque/linear/sparse_matrix.h"

namespace cirque {

/// Factors symmetric positive definite matrices given by their lower triangle and solves with the
/// factor. A matrix with the pattern of the one before reuses its symbolic analysis.
class SparseCholesky {
 public:
  virtual ~SparseCholesky() = default;

  /// False when the matrix is not positive definite in floating point (or memory ran out).
  bool Factorize(const SparseMatrix& lower);

  /// Analyses the pattern ahead of the first factorization, whatever the values. False when memory
  /// ran out.
  bool Prepare(const SparseMatrix& lower);

  /// A matrix of that many unknowns is to be factored soon: memory may be made ready while the
  /// caller goes on.
  virtual void Reserve(int unknowns) { static_cast<void>(unknowns); }

  /// x = A^-1 b with the last factor, in the memory that x has: on large meshes fresh pages cost as
  /// much as a solve. b is not x. @pre Factorize returned true.
  virtual void Solve(const Eigen::VectorXd& b, Eigen::VectorXd* x) = 0;

  Eigen::VectorXd Solve(const Eigen::VectorXd& b) {
    Eigen::VectorXd x;
    Solve(b, &x);
    return x;
  }

  /// The same of every column of b, to rounding. Several at once share the reading of the factor, which
  /// is most of the time of a solve with a large one.
  virtual void SolveTogether(const Eigen::MatrixXd& b, Eigen::MatrixXd* x);

  /// Rounds the factor to single precision: until the next factorization Solve() is right to six
  /// digits only, enough for a preconditioner, and faster.
  virtual void KeepInSinglePrecision() {}

  /// The elimination order of the last analysis, first to last; empty when it is not known.
  virtual std::vector<int> Ordering() const { return {}; }

  /// The order for the next analysis, a permutation of its unknowns. Solvers may look for another.
  virtual void SuggestOrdering(std::vector<int> order) { static_cast<void>(order); }

  int symbolic_analyses() const { return symbolic_analyses_; }
  int factorizations() const { return factorizations_; }

 protected:
  virtual bool Analyze(const SparseMatrix& lower) = 0;
  virtual bool FactorizeNumerically(const SparseMatrix& lower) = 0;

 private:
  bool AnalyzeAnew(const SparseMatrix& lower);
  bool SamePatternAsBefore(const SparseMatrix& lower) const;

  std::vector<int> column_starts_, row_indices_;
  int symbolic_analyses_ = 0, factorizations_ = 0;
};

}  // namespace cirque

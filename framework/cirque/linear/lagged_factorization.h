#pragma once

#include <memory>
#include <utility>

#include "cirque/linear/sparse_cholesky.h"
#include "cirque/linear/system_solver.h"

namespace cirque {

/// Solves by conjugate gradients, preconditioned with the last factor, kept in single
/// (SparseCholesky::KeepInSinglePrecision), and, where the matrix has changed strongly in few places, with a
/// PatchSmoother there; with a factor of the system's own, in double, when those take longer than
/// factoring anew would.
class LaggedFactorization final : public SystemSolver {
 public:
  /// `max_cg_iterations`: of a system before its matrix is factored. On the graph of a mesh an
  /// iteration costs about a twentieth of analysis and factorization, whatever the size. A goal far
  /// away makes factoring pay earlier: when the iterations on all the way there would be more.
  LaggedFactorization(std::unique_ptr<SparseCholesky> cholesky, int max_cg_iterations)
      : cholesky_(std::move(cholesky)), max_cg_iterations_(max_cg_iterations) {}

  bool WantsPattern() const override { return true; }
  void Prepare(const SparseMatrix& lower) override { cholesky_->Prepare(lower); }

  bool Solve(const SparseMatrix& lower, const Eigen::VectorXd& right_side,
             const SolveAccuracy& accuracy, Eigen::VectorXd* x, SolveSummary* summary) override;

 private:
  bool IterateOnFactor(const SparseMatrix& lower, const Eigen::VectorXd& right_side,
                       double tolerance, Eigen::VectorXd* x, SolveSummary* summary);
  bool SolveOnOwnFactor(const SparseMatrix& lower, const Eigen::VectorXd& right_side,
                        double tolerance, Eigen::VectorXd* x, SolveSummary* summary);
  bool Factorize(const SparseMatrix& lower, SolveSummary* summary);

  /// Whether a new factor saves more iterations on the way to the goal than it costs.
  bool PaysToFactor(double goal) const;

  std::unique_ptr<SparseCholesky> cholesky_;
  int max_cg_iterations_;
  bool has_factor_ = false;
  Eigen::VectorXd factored_diagonal_;
  double iterations_a_decade_ = 0;  ///< with this factor, in the last system
};

}  // namespace cirque

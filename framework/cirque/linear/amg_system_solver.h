#pragma once

#include <memory>
#include <string>

#include "cirque/linear/lagged_factorization.h"
#include "cirque/linear/multigrid.h"

namespace cirque {

struct AmgOptions {
  std::string multigrid;        ///< an element of MultigridLibrary::Methods(); empty: its first
  int max_cg_iterations = 100;  ///< a system, on its own hierarchy, before it is factored
};

/// The method that they mean.
std::string MethodOf(const AmgOptions& options, const MultigridLibrary& library);

/// Relative residual of the solves by multigrid inside conjugate gradients.
inline constexpr double kInnerMultigridTolerance = 0.1;

/// Solves by conjugate gradients, preconditioned with algebraic multigrid on what the elimination
/// of diagonal unknowns leaves (MakeEliminatingCholesky): the dual graph's Laplacian of half the
/// faces in the radii, little more than the vertices' graph Laplacian in an angle fit. In memory
/// proportional to the unknowns, where a factor takes n log n. A hierarchy serves until iterations
/// on it cost more than a new one would. Systems on which multigrid does not converge are factored,
/// and from the second on all that follow: Remark() says so.
class AmgSystemSolver final : public SystemSolver {
 public:
  explicit AmgSystemSolver(const AmgOptions& options);
  ~AmgSystemSolver() override;

  /// Says that the systems to come are near this one but for few rows. The hierarchy then is this
  /// one's, a PatchSmoother sees to those rows, and conjugate gradients on the system itself to the
  /// rest.
  void PrepareForSystemsNear(const SparseMatrix& lower, SolveSummary* summary);

  bool Solve(const SparseMatrix& lower, const Eigen::VectorXd& right_side,
             const SolveAccuracy& accuracy, Eigen::VectorXd* x, SolveSummary* summary) override;
  std::string Remark() const override;

 private:
  class Reduced;

  bool SolveByMultigrid(const SparseMatrix& lower, const Eigen::VectorXd& right_side,
                        double tolerance, Eigen::VectorXd* x, SolveSummary* summary);
  bool SolveNear(const SparseMatrix& lower, const Eigen::VectorXd& right_side, double tolerance,
                 Eigen::VectorXd* x, SolveSummary* summary);

  /// Takes the matrix, counted, for solves of what elimination leaves down to that residual.
  bool Eliminate(const SparseMatrix& lower, double target, SolveSummary* summary);

  /// Keeps why multigrid failed.
  bool Fail();

  Reduced* reduced_;  ///< belongs to elimination_
  std::unique_ptr<SparseCholesky> elimination_;
  LaggedFactorization factor_;
  Eigen::VectorXd near_diagonal_;  ///< of the matrix that systems are near; empty: none
  int max_cg_iterations_;
  int num_systems_ = 0, num_factored_ = 0;
  std::string reason_;  ///< of the last factored system
};

}  // namespace cirque

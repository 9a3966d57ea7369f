#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/solve_summary.h"
#include "cirque/linear/amg_system_solver.h"
#include "cirque/linear/lagged_hierarchy.h"
#include "cirque/linear/local_elimination.h"
#include "cirque/linear/patch_smoother.h"

namespace cirque {

/// AmgSystemSolver on ranks: one rank's part of what solves systems that change little from one to
/// the next. Every function is collective but where it says otherwise. Nothing is factored where
/// multigrid does not converge.
class RankSolver {
 public:
  /// `halo` must outlive it. `method`: of AmgOptions.
  RankSolver(const Halo* halo, std::string method, int max_cg_iterations);

  /// The matrix: these rows with `damping` added to their diagonals, which then is doubled in the
  /// rows that hold the gauge. Not collective.
  void SetRows(LocalRows rows, std::vector<int> gauge);

  /// Makes room for other rows. Not collective.
  void ForgetRows() { SetRows({{0}, {}, {}}, {}); }
  void Damp(double damping);

  /// The mean diagonal entry without damping.
  double MeanDiagonal() const;

  /// Says that the systems to come are near the present one but for few rows, whose values may
  /// change then: as AmgSystemSolver does. False where it is not positive definite.
  bool PrepareForSystemsNear(SolveSummary* summary);

  /// x of the own unknowns with |A x - b| <= tolerance |b|. False where multigrid does not come
  /// there.
  bool Solve(const Eigen::VectorXd& b, double tolerance, Eigen::VectorXd* x, SolveSummary* summary);

  /// A x of the own unknowns.
  Eigen::VectorXd Times(const Eigen::VectorXd& x) const;

  /// a.b and |a| over all ranks.
  double Dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;
  double Norm(const Eigen::VectorXd& a) const;

 private:
  /// A coupling to a ghost.
  struct Border {
    int row, ghost;
    double value;
  };

  bool Eliminate(SolveSummary* summary);
  bool SolveReduced(const Eigen::VectorXd& b, double target, Eigen::VectorXd* x,
                    SolveSummary* summary);
  bool SolveNear(const Eigen::VectorXd& b, double tolerance, Eigen::VectorXd* x,
                 SolveSummary* summary);
  void Smooth(PatchSmoother* smoother, const Preconditioner& solve, const Eigen::VectorXd& b,
              Eigen::VectorXd* x) const;

  /// b less what the ghosts' x contribute to the own rows.
  void SubtractGhosts(const Eigen::VectorXd& x, Eigen::VectorXd* b) const;
  Eigen::VectorXd WithGhosts(const Eigen::VectorXd& own) const;
  SparseMatrix OwnBlock() const;

  const Halo& halo_;
  const int max_cg_iterations_;
  LocalRows rows_;
  std::vector<int> gauge_;
  std::vector<Border> border_;
  Eigen::VectorXd diagonal_, near_diagonal_;  ///< without damping; of what systems are near
  std::unique_ptr<SharedSystem> system_;
  LaggedHierarchy hierarchy_;
  std::optional<LocalElimination> elimination_;
};

}  // namespace cirque

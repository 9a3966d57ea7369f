#pragma once

#include <string>

#include <Eigen/Core>

#include "cirque/core/solve_summary.h"
#include "cirque/linear/multigrid.h"

namespace cirque {

/// Solves by conjugate gradients on a multigrid hierarchy that may be an earlier matrix's, until
/// iterations on it cost more than a new one would. On all ranks of a SharedSystem alike.
class LaggedHierarchy {
 public:
  /// `max_iterations`: of a system on its own hierarchy.
  LaggedHierarchy(MultigridSystem* system, std::string method, int max_iterations)
      : system_(*system), method_(std::move(method)), max_iterations_(max_iterations) {}

  /// The next matrix has another pattern.
  void Forget() { has_hierarchy_ = false; }

  /// *x, from 0, with |A x - b| <= target, A the system's matrix and `norm` = |b|, on all ranks.
  /// False where the iterations do not come there, or the library fails (the system's error()).
  bool Solve(const Eigen::VectorXd& b, double norm, double target, Eigen::VectorXd* x,
             SolveSummary* summary);

 private:
  bool SetUp(SolveSummary* summary);
  int IterationsWorthTrying(double digits) const;
  bool Iterate(const Eigen::VectorXd& b, double digits, double target, int most, Eigen::VectorXd* x,
               SolveSummary* summary);

  MultigridSystem& system_;
  const std::string method_;
  const int max_iterations_;
  double digits_per_iteration_ = 0;  ///< on the hierarchy's own matrix; 0: not known yet
  bool has_hierarchy_ = false, failed_ = false;
};

}  // namespace cirque

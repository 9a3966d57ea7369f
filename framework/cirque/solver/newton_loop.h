#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "cirque/energy/energy.h"
#include "cirque/solver/line_search.h"
#include "cirque/solver/solve_run.h"

namespace cirque {

/// What is added to a Hessian's diagonal before it is factored: a multiple of the identity that
/// adapts as in Levenberg and Marquardt, and at each gauge parameter once more its own diagonal
/// entry. The gradient being orthogonal to the gauge, the solution of that definite system is
/// exactly the step that leaves the gauge parameters alone.
class LevenbergMarquardtDamping {
 public:
  explicit LevenbergMarquardtDamping(const Energy& energy);

  /// Damps a Hessian where it is.
  void DampHessian(SparseMatrix* hessian);

  /// The mean diagonal entry of a Hessian that others damp by damping().
  void SetScale(double mean_diagonal) { scale_ = mean_diagonal; }

  /// Raises the damping 100-fold, to at least 1e-5 of the mean diagonal. False when it is as high as
  /// makes sense.
  bool Raise();

  /// The same, and damps the last Hessian anew.
  bool Raise(SparseMatrix* hessian);

  /// Lowers the damping after a full step, raises it after one below 1/100.
  void Adapt(double step_length);

  double damping() const { return damping_; }

 private:
  void Apply(SparseMatrix* hessian) const;

  const double least_;
  const std::vector<int> gauge_;
  double damping_;
  double scale_ = 1;          ///< mean diagonal entry of the last Hessian
  Eigen::VectorXd diagonal_;  ///< of the last Hessian as it was
};

/// Finds when a step by the last Hessian, a chord's, does as well as one by the present one. Near the
/// minimum x* it leaves of the gradient about C |x - x*|, with x where that Hessian is from, and so did
/// the last step: the share that it left is the share that a chord's will leave.
class ChordTest {
 public:
  explicit ChordTest(const SolveRun& run);

  /// Whether the step from this gradient is then expected to end far enough below the gradient
  /// tolerance; asked once a step. Never where the energy has kinks.
  bool LastHessianDoes(const Eigen::VectorXd& gradient);

 private:
  const ParameterSpace& space_;
  const double goal_;    ///< 0: none
  double last_max_ = 0;  ///< of the gradient at the last step's start; 0: there was none
};

/// Finds a descent direction at x with this gradient, raising the damping as it must. False when
/// there is none.
using DirectionFinder =
    std::function<bool(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient,
                       LevenbergMarquardtDamping* damping, Eigen::VectorXd* direction)>;

/// How far to go along a direction.
using LineSearch = void (*)(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient,
                            const Eigen::VectorXd& direction, SolveRun* run,
                            LineSearchResult* result);

/// The iteration that Newton's method and its relatives share: direction, line search, adaption of
/// the damping, records, limits. Of energies with kinks SearchAlongKinks is the line search.
void IterateNewton(const DirectionFinder& find_direction, SolveRun* run, Eigen::VectorXd* x,
                   LineSearch search = SearchAlong);

}  // namespace cirque

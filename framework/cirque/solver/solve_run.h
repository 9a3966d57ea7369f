#pragma once

#include <limits>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/solve_summary.h"
#include "cirque/energy/energy.h"
#include "cirque/energy/parameter_space.h"
#include "cirque/linear/sparse_cholesky.h"
#include "cirque/solver/solver_strategy.h"

namespace cirque {

/// The kinks of an energy as an orthant-wise Newton method treats them (after G. Andrew, J. Gao,
/// "Scalable training of L1-regularized log-linear models", ICML 2007): a parameter at its kink is
/// held there while zero lies between its two one-sided slopes, and no step leads across a kink.
class Kinks {
 public:
  explicit Kinks(const Energy& energy) : kinks_(energy.Kinks()) {}

  bool empty() const { return kinks_.empty(); }

  /// Makes the energy's gradient at x the subgradient of least norm: at a kink the one-sided slope
  /// along which the energy falls, 0 where it falls to neither side.
  void TakeLeastSubgradient(const Eigen::VectorXd& x, Eigen::VectorXd* gradient) const;

  /// Takes the parameters that x holds at a kink out of the Hessian: their rows and columns vanish
  /// but for the diagonal. `subgradient` is that of TakeLeastSubgradient at x.
  void Hold(const Eigen::VectorXd& x, const Eigen::VectorXd& subgradient,
            SparseMatrix* lower) const;

  /// Stops every parameter at its kink which in `trial` lies on another side of it than x does, or
  /// than the subgradient leads to from the kink.
  void StopAt(const Eigen::VectorXd& x, const Eigen::VectorXd& subgradient,
              Eigen::VectorXd* trial) const;

 private:
  const std::vector<Kink> kinks_;
};

/// The bookkeeping of one solve: counts and times evaluations, keeps the
/// records, asks the callback, and knows when to end.
class SolveRun {
 public:
  SolveRun(std::string strategy, const SolverLimits& limits, const SolveControl& control,
           const Energy& energy);

  /// The energy's forms at x, counted and timed. False outside the domain. Of an energy with kinks:
  /// the subgradient of least norm, and the Hessian of the parameters that are not held at theirs.
  bool Value(const double* x, double* value, Eigen::VectorXd* gradient);  ///< gradient may be null
  bool Gradient(const Eigen::VectorXd& x, Eigen::VectorXd* gradient);
  bool Hessian(const Eigen::VectorXd& x, SparseMatrix* lower);

  /// Lets the energy lower itself where few entries of the gradient stand out (Energy::Relax), a
  /// few times, as long as that makes the largest entry smaller.
  void Relax(Eigen::VectorXd* x, Eigen::VectorXd* gradient);

  /// Factors and solves, counted and timed.
  bool Factorize(const SparseMatrix& lower, SparseCholesky* cholesky);
  Eigen::VectorXd Solve(const Eigen::VectorXd& right_side, SparseCholesky* cholesky);

  /// Evaluates value and gradient at the start. False (and ended as kInvalidStart) outside the
  /// domain.
  bool Begin(const Eigen::VectorXd& x, Eigen::VectorXd* gradient);

  /// For strategies that know smooth energies only: false (and ended as kUnsupported) where there
  /// are kinks.
  bool RequireSmooth();

  /// Whether another step is due at this gradient; otherwise the termination is set.
  bool Continue(const Eigen::VectorXd& gradient);

  /// For second-order methods: ends the solve where the gradient, small already, has not become
  /// smaller for some steps.
  bool StoppedAtRounding(const Eigen::VectorXd& gradient);

  /// Records an accepted step, its value where the strategy knows it. False when the callback ended
  /// the solve.
  bool Accept(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient, double step_length,
              double value = kUnset);

  /// Ends the solve for a reason of the strategy's own.
  void End(Termination termination, std::string message);

  /// The summary, with the final value at x if the solve began.
  SolveSummary Finish(const Eigen::VectorXd& x);

  SolveSummary& summary() { return summary_; }
  double gradient_tolerance() const { return limits_.gradient_tolerance; }
  const Energy& energy() const { return energy_; }
  const ParameterSpace& space() const { return energy_.space(); }
  const Kinks& kinks() const { return kinks_; }

 private:
  bool CallerStops(const IterationRecord& record, const Eigen::VectorXd& x) const;

  const SolverLimits limits_;
  const SolveControl& control_;
  const Energy& energy_;
  const Kinks kinks_;
  Eigen::VectorXd relaxed_, relaxed_gradient_;
  Timer timer_;
  SolveSummary summary_;
  double least_gradient_ = std::numeric_limits<double>::infinity();
  int steps_since_least_ = 0;
};

}  // namespace cirque

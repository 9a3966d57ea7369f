#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/angles/angle_fit_problem.h"
#include "cirque/energy/angle_objective.h"
#include "cirque/energy/edge_block_assembler.h"
#include "cirque/energy/energy.h"

namespace cirque {

/// An angle fit of an objective that measures corner angles only, written out:
///   minimise sum_i delta(x_i; c_i)   subject to   B x = b,   G x >= h.
/// x holds the 3F angles and after them a variable t in [lower, upper] (delta = 0) for every ranged
/// vertex, whose row of B then says: angle sum - t = 0. A row of G has one or two equal entries +-1
/// and touches one edge's angles, or one t.
class AngleProgram {
 public:
  /// The program of a fit, linearised at the centre. Constraints and objective must outlive it.
  /// @pre not objective.MeasuresTheta().
  AngleProgram(const AngleFitProblem& problem, const AngleObjective& objective);

  int num_variables() const { return static_cast<int>(weight_.size()); }
  int num_inequalities() const { return static_cast<int>(inequalities_.size()); }
  const Eigen::VectorXd& centre() const { return centre_; }

  /// Takes value, slope (delta') and weight (delta'') at x. @pre x lies in the objective's domain.
  void Linearize(const Eigen::VectorXd& x);

  double value() const { return value_; }
  const Eigen::VectorXd& slope() const { return slope_; }
  const Eigen::VectorXd& weight() const { return weight_; }

  Eigen::VectorXd EqualityResidual(const Eigen::VectorXd& x) const;  ///< B x - b
  Eigen::VectorXd Slacks(const Eigen::VectorXd& x) const;            ///< G x - h
  Eigen::VectorXd ApplyB(const Eigen::VectorXd& x) const;
  Eigen::VectorXd ApplyTransposedB(const Eigen::VectorXd& y) const;
  Eigen::VectorXd ApplyG(const Eigen::VectorXd& x) const;
  Eigen::VectorXd ApplyTransposedG(const Eigen::VectorXd& z) const;

  /// A point with G x > h (for margins below pi / 3), near the centre where that has room.
  Eigen::VectorXd InteriorPoint() const;

  /// D = diag(w) + G' diag(q) G couples the two angles of an edge only; it is inverted by hand.
  class Blocks {
   public:
    Blocks(const AngleProgram& program, const Eigen::VectorXd& q);
    /// D^-1 v.
    Eigen::VectorXd Solve(const Eigen::VectorXd& v) const;
    /// G x for x = D^-1 v, the sums of two angles without cancellation.
    Eigen::VectorXd ApplyGToSolution(const Eigen::VectorXd& v, const Eigen::VectorXd& x) const;
    /// B D^-1 B', lower triangle. Both are those of the step before, or new ones: what couples what
    /// changes seldom.
    void NormalMatrix(EdgeBlockAssembler* assembler, SparseMatrix* lower) const;

   private:
    double Determinant(int i, int j) const;

    const AngleProgram& program_;
    Eigen::VectorXd own_;     ///< w_i + q of the inequalities on i alone
    Eigen::VectorXd shared_;  ///< q of the inequality that i shares with its partner
  };

 private:
  struct Inequality {
    int i, j;  ///< j = kNone: x_i alone
    double sign, bound;
  };

  void AddEdge(Index l, Index r, const EdgeMargins& margins);
  void AddRange(int variable, int row);

  const AngleConstraints& constraints_;
  const AngleObjective& objective_;
  Eigen::VectorXd centre_, slope_, weight_;
  double value_ = 0;
  std::vector<int> partner_;     ///< the other angle of a variable's edge, or kNone
  std::vector<int> ranged_row_;  ///< the row of each t
  std::vector<Inequality> inequalities_;
};

}  // namespace cirque

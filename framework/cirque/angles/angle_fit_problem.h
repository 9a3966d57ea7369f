#pragma once

#include <Eigen/Core>

#include "cirque/core/solve_summary.h"
#include "cirque/energy/angle_constraints.h"
#include "cirque/energy/angle_objective.h"

namespace cirque {

/// Find coherent angles near reference angles (docs/mathematics.md, Angle fits):
///   minimise phi(alpha)                              an AngleObjective
///   over     A alpha = b                             triangle sums pi, vertex sums in their targets,
///            alpha_e in Q_e(epsilon) for every edge e.
struct AngleFitProblem {
  const AngleConstraints& constraints;
  const Eigen::VectorXd& reference;        ///< 3F [rad]
  double epsilon;                          ///< margin [rad]
  const Eigen::VectorXd* start = nullptr;  ///< multipliers near the solution's, one a row of A;
                                           ///< null: 0. Solvers need not use them
};

/// The margins of the edge of halfedge h, which is on its left.
EdgeMargins MarginsOf(const AngleFitProblem& problem, const AngleObjective& objective, Index h);

/// How nearly angles alpha and multipliers y satisfy the optimality conditions of an angle fit: the
/// same for every solver, so that solvers can be compared. With m the margins of the edge's
/// Q_e, s = A alpha, phi the objective; angles in radians.
///
/// At an edge, stationarity
///   A'y - grad phi(alpha) = mu (1, 1) - (lambda_l, lambda_r)
/// implies multipliers lambda of alpha >= m and mu of alpha_l + alpha_r <= pi - m (boundary: of
/// alpha <= pi - m), once that of the constraint with the largest slack is 0: Q_e is a triangle (an
/// interval), at most two (one) of its sides can be active.
struct KktReport {
  double triangle_sum_residual = kUnset;  ///< max_f |s_f - pi|
  double vertex_sum_residual = kUnset;    ///< max_v distance of s_v from its target interval
  double smallest_angle = kUnset;         ///< min alpha
  double smallest_theta = kUnset;         ///< min over edges of theta
  double inequality_violation = kUnset;   ///< max(0, m - alpha, m - theta); 0 without Q_e

  double primal = kUnset;  ///< sum_e phi_e(alpha)
  double dual = kUnset;    ///< b.y - sum_e g_e((A'y)_e): a lower bound of every feasible primal

  /// max over corners of |alpha - argmax over Q_e of (A'y).a - phi(a)|: how far alpha is from what
  /// the multipliers ask for.
  double stationarity = kUnset;
  /// max over edges of -min(0, lambda, mu), relative to 1 + max |A'y|.
  double dual_infeasibility = kUnset;
  /// max over inequalities of |multiplier * slack|, and over ranged vertices of
  /// max(y, 0) |s - lower| and max(-y, 0) |upper - s|; relative to 1 + |primal|.
  double complementarity = kUnset;

  /// |primal - dual| / (1 + |primal|).
  double RelativeGap() const;
};

/// Fills in triangle_sum_residual, vertex_sum_residual, smallest_angle and smallest_theta.
KktReport CheckFeasibility(const AngleConstraints& constraints, const Eigen::VectorXd& alpha);

/// The whole report. Entries are not finite where alpha lies outside the objective's domain.
KktReport CheckKkt(const AngleFitProblem& problem, const AngleObjective& objective,
                   const Eigen::VectorXd& alpha, const Eigen::VectorXd& y);

}  // namespace cirque

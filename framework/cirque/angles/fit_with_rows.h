#pragma once

#include <memory>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "cirque/angles/angle_fit.h"
#include "cirque/angles/angle_fit_problem.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/energy/angle_objective.h"
#include "cirque/linear/sparse_cholesky.h"

namespace cirque {

/// A few equations more than an angle fit has: rows' (alpha - from) = change, rows 3F x m and
/// dense. Of differences, since the sums themselves are so long that rounding would show.
struct ExtraRows {
  const Eigen::MatrixXd& rows;
  const Eigen::VectorXd& from;  ///< 3F angles [rad]
  Eigen::VectorXd change;
};

/// What fits whose rows differ little leave to the next.
struct RowFitMemory {
  Eigen::VectorXd z;                   ///< multipliers of the rows; empty: 0
  Eigen::MatrixXd projection;          ///< rows of A that are taken from each; empty: not known yet
  Eigen::LDLT<Eigen::MatrixXd> schur;  ///< of some earlier point: a preconditioner
  std::unique_ptr<SparseCholesky> factor;  ///< of A P A', whose pattern is always the same
};

/// The angles of a fit with extra rows: the Lagrange dual in (y, z),
///   f(y, z) = sum_e g_e((A'y + C'z)_e) - b.y - c.z,       C = rows', c = C from + change,
/// g_e the conjugates of the objective over Q_e (DualAngleEnergy), by Newton's method with Armijo's
/// rule. A step costs one factorization of the fit's own A P A' (P = d alpha / d s, block by edge);
/// z follows from the Schur complement S = C P C' - C P A' (A P A')^-1 A P C', by conjugate
/// gradients preconditioned with the S of an earlier point, which is formed anew (m solves and a
/// product of dense matrices) only where that one tells too little. Rows of A are projected away
/// from the extra ones at the start, lest the difference cancel.
///
/// Of `memory`, z is what the multipliers of the rows start from, and those found; problem.start
/// those of A. Of the result, angles, multipliers and kkt's feasibility are filled in. Errors: not
/// converged, where no such angles exist or Newton finds none; invalid input for ranged angle sums,
/// of which the dual has kinks. Then z stays as it was.
Status FitWithRows(const AngleFitProblem& problem,
                   const std::shared_ptr<const AngleObjective>& objective, const ExtraRows& extra,
                   const SolveControl& control, RowFitMemory* memory, AngleFitResult* result);

}  // namespace cirque

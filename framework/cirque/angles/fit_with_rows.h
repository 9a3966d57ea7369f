#pragma once

#include <memory>

#include <Eigen/Core>

#include "cirque/angles/angle_fit.h"
#include "cirque/angles/angle_fit_problem.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/energy/angle_objective.h"

namespace cirque {

/// A few equations more than an angle fit has: rows' (alpha - from) = change, rows 3F x m and
/// dense. Of differences, since the sums themselves are so long that rounding would show.
struct ExtraRows {
  Eigen::MatrixXd rows;
  const Eigen::VectorXd& from;  ///< 3F angles [rad]
  Eigen::VectorXd change;
};

/// The angles of a fit with extra rows: the Lagrange dual in (y, z),
///   f(y, z) = sum_e g_e((A'y + C'z)_e) - b.y - c.z,       C = rows', c = C from + change,
/// g_e the conjugates of the objective over Q_e (DualAngleEnergy), by Newton's method with Armijo's
/// rule. A step costs one factorization of the fit's own A P A' (P = d alpha / d s, block by edge)
/// and m solves with it; z follows from the Schur complement C P C' - C P A' (A P A')^-1 A P C',
/// which is formed of rows from which A's have been projected away at the start, lest the
/// difference cancel.
///
/// `z` is what the multipliers of the rows start from (empty: 0) and those found; problem.start
/// those of A. Of the result, angles, multipliers and kkt's feasibility are filled in. Errors: not
/// converged, where no such angles exist or Newton finds none; invalid input for ranged angle sums,
/// of which the dual has kinks.
Status FitWithRows(const AngleFitProblem& problem,
                   const std::shared_ptr<const AngleObjective>& objective, const ExtraRows& extra,
                   const SolveControl& control, Eigen::VectorXd* z, AngleFitResult* result);

}  // namespace cirque

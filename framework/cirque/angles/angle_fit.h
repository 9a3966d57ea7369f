#pragma once

#include <memory>

#include "cirque/angles/angle_fit_problem.h"
#include "cirque/core/infeasibility.h"
#include "cirque/core/metric.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/energy/angle_objective.h"

namespace cirque {

/// What a fit found; all solvers fill all of it.
struct AngleFitResult {
  CoherentAngles angles;
  Eigen::VectorXd multipliers;  ///< y of A alpha = b, rows as in AngleConstraints:
                                ///< grad phi = A'y up to the inequalities' share
  SolveSummary solve;
  KktReport kkt;
  int clamped_references = 0;              ///< reference angles that the objective had to clamp
  InfeasibilityCertificate infeasibility;  ///< filled with kInfeasible
};

/// A way to solve an angle fit at one margin (docs/mathematics.md, Angle fits).
class AngleSolver {
 public:
  virtual ~AngleSolver() = default;

  /// Errors: kInfeasible with a certificate when no coherent system with that margin exists,
  /// kNotConverged when neither angles nor a certificate were found, kInvalidInput for an objective
  /// that the solver does not take, kCancelled. The callback of `control` gets the solver's own
  /// unknowns (multipliers or angles).
  virtual Status Fit(const AngleFitProblem& problem,
                     const std::shared_ptr<const AngleObjective>& objective,
                     const SolveControl& control, AngleFitResult* result) const = 0;
};

/// Fits with the first margin of epsilon, epsilon / 10, ..., 1e-8 rad that is feasible: high
/// valences can make a coherent system exist for small margins only. Starts below epsilon where a
/// vertex's corners would fill half its angle sum with margins alone. The result's angles carry the
/// margin that was used.
Status FitAngles(const AngleFitProblem& problem,
                 const std::shared_ptr<const AngleObjective>& objective, const AngleSolver& solver,
                 const SolveControl& control, AngleFitResult* result);

/// What every solver does at its end: kInfeasible with the certificate when there is one, else
/// closes the triangle sums of `alpha` to rounding, takes alpha and `multipliers` as the result and
/// reports on them. kNotConverged: angles whose sums (before closing) miss by more than 1e-9 rad,
/// or of an unconverged solve whose relative gap exceeds 1e-8, and angles that are no circle
/// pattern's (an objective without inequalities can have such).
Status FinishFit(const AngleFitProblem& problem, const AngleObjective& objective,
                 InfeasibilityCertificate certificate, Eigen::VectorXd alpha,
                 Eigen::VectorXd multipliers, AngleFitResult* result);

/// Makes triangle sums exact to rounding: the radii's gradient sums to their total error.
void CloseTriangles(Eigen::VectorXd* alpha);

/// "no coherent angles exist: ...", with the faces and vertices that the proof says it of.
std::string InfeasibleMessage(const InfeasibilityCertificate& certificate);

}  // namespace cirque

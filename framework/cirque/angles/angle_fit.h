#pragma once

#include <memory>

#include "cirque/angles/angle_fit_problem.h"
#include "cirque/angles/kkt_report.h"
#include "cirque/core/infeasibility.h"
#include "cirque/core/metric.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/energy/angle_objective.h"

namespace cirque {

/// What a fit found; all methods fill all of it.
struct AngleFitResult {
  CoherentAngles angles;
  Eigen::VectorXd multipliers;  ///< y of A alpha = b, rows as in AngleConstraints: grad phi = A'y
                                ///< up to the inequalities' share
  SolveSummary solve;
  KktReport kkt;
  int clamped_references = 0;              ///< reference angles that the objective had to clamp
  InfeasibilityCertificate infeasibility;  ///< filled with kInfeasible
};

/// A way to solve an angle fit at one margin.
class AngleFitMethod {
 public:
  virtual ~AngleFitMethod() = default;

  /// kInfeasible with a proof when no coherent system with that margin exists, kNotConverged when
  /// neither angles nor a proof were found, kInvalidInput for an objective that the method does not
  /// take. The callback of `control` gets the method's own unknowns (multipliers or angles).
  virtual Status Fit(const AngleFitProblem& problem,
                     const std::shared_ptr<const AngleObjective>& objective,
                     const SolveControl& control, AngleFitResult* result) const = 0;
};

/// Fits with the first margin of epsilon, epsilon / 10, ..., 1e-8 rad that is feasible: high
/// valences can make a coherent system exist for small margins only. Starts below epsilon where a
/// vertex's corners would fill half its angle sum with margins alone. The result's angles carry the
/// margin that was used.
Status FitAngles(const AngleFitProblem& problem,
                 const std::shared_ptr<const AngleObjective>& objective,
                 const AngleFitMethod& method, const SolveControl& control, AngleFitResult* result);

/// What every method does at its end: kInfeasible with the proof when there is one, else closes the
/// triangle sums of `alpha` to rounding, takes alpha and `multipliers` as the result and reports on
/// them. Angles whose sums (before closing) miss by more than 1e-9 rad, or
/// of an unconverged solve whose relative gap exceeds 1e-8, are kNotConverged, and so are angles
/// that are no circle pattern's (an objective without inequalities can have such).
Status FinishFit(const AngleFitProblem& problem, const AngleObjective& objective,
                 InfeasibilityCertificate proof, Eigen::VectorXd alpha, Eigen::VectorXd multipliers,
                 AngleFitResult* result);

}  // namespace cirque

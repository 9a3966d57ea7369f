#pragma once

#include <string>

#include "cirque/angles/kkt_report.h"
#include "cirque/core/infeasibility.h"
#include "cirque/core/metric.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/energy/angle_constraints.h"
#include "cirque/energy/angle_objective.h"
#include "cirque/solver/solver_strategy.h"

namespace cirque {

/// Find coherent angles near reference angles: minimise the objective over
///   A alpha = b (triangle sums pi, vertex sums in their targets), alpha_e in Q_e(epsilon) for
///   every edge e.
struct AngleFitProblem {
  const AngleConstraints& constraints;
  const Eigen::VectorXd& reference;  ///< 3F [rad]
  double epsilon;                    ///< margin [rad]
};

struct AngleFitResult {
  CoherentAngles angles;
  SolveSummary solve;
  KktReport kkt;
  int clamped_references = 0;        ///< reference angles that the objective had to clamp
  InfeasibilityProof infeasibility;  ///< filled with kInfeasible
};

/// Fits by minimising the Lagrange dual with any strategy. kInfeasible with a proof when no
/// coherent system with that margin exists, kNotConverged when neither angles nor a proof were
/// found.
Status FitAnglesByDual(const AngleFitProblem& problem,
                       const std::shared_ptr<const AngleObjective>& objective,
                       const SolverStrategy& strategy, const SolveControl& control,
                       AngleFitResult* result);

/// As above for the first margin of epsilon, epsilon / 10, ..., 1e-8 rad that is feasible: high
/// valences can make a coherent system exist for small margins only. Starts below epsilon where a
/// vertex's corners would fill half its angle sum with margins alone. The result's angles carry the
/// margin that was used.
Status FitAngles(const AngleFitProblem& problem,
                 const std::shared_ptr<const AngleObjective>& objective,
                 const SolverStrategy& strategy, const SolveControl& control,
                 AngleFitResult* result);

}  // namespace cirque

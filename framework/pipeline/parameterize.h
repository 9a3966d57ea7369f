#pragma once

#include <string>

#include "cirque/core/metric.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/mesh/surface.h"
#include "cirque/pipeline/certificate.h"

namespace cirque {

/// How to parameterize. Every field has a flag of circle_patterns and a key of an experiment config
/// by its name.
struct ParameterizeOptions {
  std::string angle_fit = "quadratic";    ///< a name of AngleObjectives()
  std::string angle_strategy = "newton";  ///< a name of AngleStrategyNames()
  std::string strategy = "newton";        ///< a name of SolverStrategies(), for the log radii
  double epsilon = 1e-3;     ///< least corner and intersection angle [rad]; shrinks where it must
  int max_iterations = 100;  ///< of each solve
};

/// What comes out of every stage.
struct Parameterization {
  CoherentAngles angles;
  LogRadii log_radii;
  CornerUv uv;
  Certificate certificate;  ///< filled as far as the stages came, whatever the outcome
};

/// Flattens a disk whose angle sums shall lie in `targets` (FreeBoundaryTargets for the usual map):
/// coherent angles, log radii, layout. The status is kInfeasible (the certificate holds the proof),
/// kUnrepresentable or kNotConverged when there is no map; `result` then carries no uv.
Status Parameterize(const Surface& surface, const ConeTargets& targets,
                    const ParameterizeOptions& options, const SolveControl& control,
                    Parameterization* result);

}  // namespace cirque

#pragma once

#include <memory>

#include "cirque/core/metric.h"
#include "cirque/core/parallel.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/solver/solver_strategy.h"

namespace cirque {

/// The log radii of a circle pattern and the evidence for them.
struct LogRadiiResult {
  LogRadii log_radii;
  SolveSummary start;            ///< the linear algebra of the start
  SolveSummary solve;            ///< of the strategy, from there
  double gradient_max = kUnset;  ///< largest deviation of a face's angle sum from pi, doubled [rad]
  double energy = kUnset;        ///< S at the solution
  double dual_energy =
      kUnset;  ///< Rivin's and Leibon's dual at the same point: equal to S at the minimum

  double RelativeGap() const;
};

/// What solves SolveLogRadii's linear systems, as the strategy wants it. The analysis of their
/// pattern needs the triangulation alone: it starts with the construction and may go on beside the
/// angle fit.
class RadiiSystem {
 public:
  /// `triangulation` must outlive the system.
  RadiiSystem(const Triangulation& triangulation, const SolverStrategy& strategy);

  /// Waits for the analysis.
  SystemSolver* Get();

 private:
  std::unique_ptr<SystemSolver> solver_;
  BackgroundTask analysis_;
};

/// Minimises the circle-pattern energy of the coherent angles from the least-squares start
/// (docs/mathematics.md, Radii). kNotConverged when the gradient stays above 1e-9 rad.
Status SolveLogRadii(const Triangulation& triangulation, const CoherentAngles& angles,
                     const SolverStrategy& strategy, const SolveControl& control,
                     RadiiSystem* system, LogRadiiResult* result);

/// With a system of its own.
Status SolveLogRadii(const Triangulation& triangulation, const CoherentAngles& angles,
                     const SolverStrategy& strategy, const SolveControl& control,
                     LogRadiiResult* result);

/// The corner angles phi of the flat triangles with these radii [rad], 3F, and their edge lengths
/// 2 e^rho sin(phi), E.
CornerAngles FlatCornerAngles(const Triangulation& triangulation, const CoherentAngles& angles,
                              const LogRadii& log_radii);
EdgeLengths FlatEdgeLengths(const Triangulation& triangulation, const CornerAngles& flat_angles,
                            const LogRadii& log_radii);

}  // namespace cirque

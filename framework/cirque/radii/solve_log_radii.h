#pragma once

#include <memory>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/parallel.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/energy/circle_pattern_energy.h"
#include "cirque/linear/system_solver.h"
#include "cirque/solver/solver_strategy.h"

namespace cirque {

/// The log radii of a circle pattern and the evidence for them.
struct LogRadiiResult {
  LogRadii log_radii;
  SolveSummary start;            ///< the linear algebra of the start
  SolveSummary solve;            ///< of the strategy, from there
  double gradient_max = kUnset;  ///< largest deviation of a face's angle sum from pi, doubled [rad]
  double energy = kUnset;        ///< S at the solution
  double dual_energy = kUnset;   ///< Rivin's and Leibon's dual there: equal to S at the minimum

  /// |energy - dual_energy| / (1 + |energy|).
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

/// Minimises the circle-pattern energy of the coherent angles from MaximizePatternVolume's start
/// (docs/mathematics.md, Radii): the log radii, of mean 0, whose flat triangles meet at every edge
/// under its theta. All of `result` is filled in whatever the outcome. Errors: kNotConverged when
/// the gradient stays above 1e-9 rad (the intersection angles then need not belong to any flat
/// surface), or when angles are coherent only up to rounding (the radii are then all 1);
/// kCancelled.
Status SolveLogRadii(const Triangulation& triangulation, const CoherentAngles& angles,
                     const SolverStrategy& strategy, const SolveControl& control,
                     RadiiSystem* system, LogRadiiResult* result);

/// With a system of its own.
Status SolveLogRadii(const Triangulation& triangulation, const CoherentAngles& angles,
                     const SolverStrategy& strategy, const SolveControl& control,
                     LogRadiiResult* result);

/// The corner angles of the flat triangles with these radii, 3F [rad]:
///   phi = theta*/2 - atan(tanh(d/2) tan(theta*/2))   opposite interior edges, d = rho_i - rho_j,
///   alpha                                            opposite boundary edges, and opposite those
///                                                    between two triangles on one circle
///                                                    (theta < 1e-9), of which d tells nothing.
/// A face's three add up to pi where the radii are those of the pattern.
CornerAngles FlatCornerAngles(const Triangulation& triangulation, const CoherentAngles& angles,
                              const LogRadii& log_radii);

/// Their edge lengths 2 e^rho sin(phi), E, of the face on the left of each edge's halfedge.
EdgeLengths FlatEdgeLengths(const Triangulation& triangulation, const CornerAngles& flat_angles,
                            const LogRadii& log_radii);

}  // namespace cirque

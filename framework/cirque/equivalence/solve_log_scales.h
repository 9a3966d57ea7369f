#pragma once

#include "cirque/core/metric.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/equivalence/scaled_metric.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"
#include "cirque/solver/solver_strategy.h"

namespace cirque {

/// A discretely conformally equivalent flat metric, or how far the solve came.
struct LogScalesResult : ScaledMetric {
  bool doubled = false;             ///< of the surface's double; log_scale is V of the surface
  IntrinsicTriangulation delaunay;  ///< of the surface's (or its double's) own metric
  SolveSummary solve;               ///< the last; counts of all
};

/// Which edges are not flipped.
enum class KeptEdges {
  kNoEdge,    ///< a surface with a boundary is doubled, so that a solution always exists
  kBoundary,  ///< those of the boundary, which cannot
  kAll        ///< nothing is flipped: where that has a solution, it is one of the input's triangles
};

/// Minimises ConformalEquivalenceEnergy with Ptolemy flips, after flips that make the surface's own
/// metric Delaunay. Vertices with lower < upper on the boundary keep their scale, u = 0; angle sums
/// of inner ones are taken from within their intervals, so that all add up (docs/mathematics.md,
/// Conformal equivalence). With kNoEdge, and with kBoundary on every closed surface, a solution exists for all
/// angle sums above 0 with Gauss-Bonnet where no scale is held, and with held ones on the boundary
/// unless what the others leave to it is negative.
///
/// Where scales are as large as tens, E is all but linear between narrow creases: what the strategy does
/// not reach on a closed surface MinimizeByLaplacians is given, some iterations at a time, from 0 and
/// along paths from easier problems.
///
/// The residual is that of a triangulation flipped anew at the solution. Errors: kNotConverged with
/// a residual above 1e-10 rad, or above what rounding leaves of such lengths if that is more (1e-6 at
/// most), or with an angle of 0 (beside edges that are kept); kUnrepresentable where it is what
/// rounding of lengths with three times a double's digits leaves; kCancelled.
Status SolveLogScales(const Triangulation& triangulation, const EdgeLengths& lengths,
                      const ConeTargets& targets, KeptEdges kept, const SolverStrategy& strategy,
                      const SolveControl& control, LogScalesResult* result);

/// Angle sums for ScaleTargets: fixed ones as they are; intervals of inner vertices all at the same
/// fraction of their width, by Gauss-Bonnet where no other vertex is held, half of it elsewhere;
/// the rest of the boundary free.
ConeTargets FixedTargets(const Triangulation& triangulation, const ConeTargets& targets);

}  // namespace cirque

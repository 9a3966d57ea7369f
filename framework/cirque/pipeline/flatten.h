#pragma once

#include <functional>
#include <vector>

#include "cirque/core/infeasibility.h"
#include "cirque/core/metric.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/input_chart.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/pipeline/certificate.h"
#include "cirque/pipeline/options.h"

namespace cirque {

/// A flat cone metric conformal to the input's, where it was solved and as the input's triangles
/// have it.
struct FlatSurface {
  IntrinsicTriangulation intrinsic;  ///< where it was solved; without flips: the input itself
  CoherentAngles angles;             ///< of intrinsic
  Eigen::VectorXd multipliers;       ///< of the angle fit, rows as in AngleConstraints
  LogRadii log_radii;                ///< of intrinsic; the image has the area of the surface
  EdgeLengths intrinsic_lengths;     ///< flat, of intrinsic: with it a CON file
  InputChart on_input;
  InfeasibilityCertificate infeasibility;  ///< with kInfeasible: why there is none
};

/// Solves with these edges (a flag per edge of the input) locked; returns the input's faces that
/// come out flipped, of which none are left when there are none or locking would not help.
using SolveWithLocked =
    std::function<StatusOr<std::vector<Index>>(const std::vector<bool>& locked)>;

/// Locks edges for the sake of flipped faces; false: there is none left to lock.
using LockFlipped =
    std::function<bool(const std::vector<Index>& flipped, std::vector<bool>* locked)>;

/// How often SolveLockingFlipped locks edges.
inline constexpr int kMostLockingRounds = 4;

/// The lazily constrained loop: solves, locks edges of the faces that came out flipped, which then
/// are faces of the pattern, and solves again, kMostLockingRounds times at most. Returns the
/// flipped faces of the last round, or its error.
StatusOr<std::vector<Index>> SolveLockingFlipped(std::vector<bool> locked,
                                                 const SolveWithLocked& solve,
                                                 const LockFlipped& lock);

/// What is to be flattened, and how.
struct FlattenJob {
  const IntrinsicSurface& surface;
  const ConeTargets& targets;
  const ParameterizeOptions& options;
  const SolveControl& control;
  /// Edges of the surface that are locked from the first round on; null: none.
  const std::vector<bool>* locked = nullptr;
};

/// Coherent angles and log radii for the targets, on intrinsic Delaunay connectivity unless the
/// options say otherwise. Where input triangles come out flipped, single vertices are moved
/// (UntangleFlippedTriangles); those that no move rights get their edges locked, and everything is
/// solved again (SolveLockingFlipped). The last resort, also where the flipped connectivity has no
/// coherent angles, is the input's own, on which none can be flipped. Proofs of infeasibility are
/// therefore about the input's connectivity. The certificate receives the summaries of
/// triangulation, angle fit and radii, and their times.
Status Flatten(const FlattenJob& job, Certificate* certificate, FlatSurface* result);

}  // namespace cirque

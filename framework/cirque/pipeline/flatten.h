#pragma once

#include <functional>
#include <vector>

#include "cirque/core/status.h"
#include "cirque/core/types.h"
#include "cirque/pipeline/certificate.h"
#include "cirque/pipeline/flat_surface.h"

namespace cirque {

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

/// Coherent angles and log radii for the targets, on intrinsic Delaunay connectivity unless the
/// options say otherwise. Where input triangles come out flipped, single vertices are moved
/// (UntangleFlippedTriangles); those that no move rights get their edges locked, and everything is
/// solved again (SolveLockingFlipped). The last resort, also where the flipped connectivity has no
/// coherent angles, is the input's own, on which none can be flipped; where that has none either and
/// an exact map is asked for, the first solution stays with its flipped triangles. Proofs of infeasibility are
/// therefore about the input's connectivity. The certificate receives the summaries of
/// triangulation, angle fit and radii, and their times.
Status Flatten(const FlattenJob& job, Certificate* certificate, FlatSurface* result);

}  // namespace cirque

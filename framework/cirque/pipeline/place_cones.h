#pragma once

#include "cirque/core/infeasibility.h"
#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/io/cone_file.h"
#include "cirque/pipeline/options.h"

namespace cirque {

/// Interior vertices flat, boundary vertices free. A closed surface: as many cones as those of
/// SimpleConeTargets, moved by `moving:measure=angle` unless they are more than 96.
StatusOr<ConeTargets> DefaultTargets(const IntrinsicSurface& surface);

/// The targets that the options' cone heuristic chooses, sought on the metric's intrinsic Delaunay
/// connectivity, with the angles the options ask for; DefaultTargets when they name no heuristic.
/// `file`: how a cone file numbers the vertices; empty: in order. Errors (invalid input): an
/// unknown name or option, cones that Gauss-Bonnet or the corners forbid.
StatusOr<ConeTargets> PlaceCones(const IntrinsicSurface& surface, const FileVertices& file,
                                 const ParameterizeOptions& options);

/// What a repair did.
struct ConeRepair {
  ConeTargets targets;
  int moved = 0, widened = 0;  ///< cones
};

/// Changes the inner cones of infeasible targets where the proof points: those at its carrying
/// vertices or next to one; all cones where it points at none. In round 1 each of them moves to the
/// neighbour with most corners, if that has more and is no cone yet; in round k > 1 its angle may
/// range over +- (k - 1) pi/4, and that of every other cone over a quarter of that, which Gauss-
/// Bonnet needs. Angles stay within what the corners can reach.
ConeRepair RepairCones(const IntrinsicSurface& surface, const ConeTargets& targets,
                       const InfeasibilityCertificate& proof, int round);

inline constexpr int kMostConeRepairs = 5;

}  // namespace cirque

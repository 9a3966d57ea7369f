#pragma once

#include <optional>

#include "cirque/core/metric.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/mesh/surface.h"
#include "cirque/pipeline/certificate.h"
#include "cirque/pipeline/flatten.h"
#include "cirque/pipeline/options.h"

namespace cirque {

/// What comes out of every stage.
struct Parameterization {
  ConeTargets targets;  ///< what the angle sums were asked to be in the end
  FlatSurface flat;
  Cut cut;                  ///< edges of the surface along which it was opened for the layout
  CornerUv uv;              ///< of the surface's own corners; several at a vertex on the cut
  Certificate certificate;  ///< filled as far as the stages came, whatever the outcome
};

/// What to parameterize for.
struct ParameterizeRequest {
  ParameterizeOptions options = {};
  /// The interval of every vertex's angle sum. Nothing: the cones that the options name
  /// (PlaceCones); where they turn out infeasible they are moved and widened where the proof points
  /// (RepairCones) before there is no map.
  std::optional<ConeTargets> targets = {};
  std::optional<Cut> cut = {};  ///< nothing: a short one through the cones is found
};

/// DefaultTargets (cone_stages.h) of a surface in space.
StatusOr<ConeTargets> DefaultTargets(const Surface& surface);

/// Maps a surface of any topology to the plane: intrinsic Delaunay flips, coherent angles, log
/// radii, a cut through the cones, layout. The status is kInfeasible (the certificate holds the
/// proof), kUnrepresentable or kNotConverged when there is no map, kInvalidInput for targets or a
/// cut that fit no map; `result` then carries no uv.
Status Parameterize(const Surface& surface, const ParameterizeRequest& request,
                    const SolveControl& control, Parameterization* result);

/// The same for an intrinsic metric without points.
Status Parameterize(const Triangulation& triangulation, const EdgeLengths& lengths,
                    const ParameterizeRequest& request, const SolveControl& control,
                    Parameterization* result);

/// Cuts and lays out a metric that is flat but for cones already; nothing is solved. Interior
/// vertices whose angles do not add up to 2 pi (within 1e-6 rad) are its cones.
Status LayOutFlatMetric(const Triangulation& triangulation, const EdgeLengths& lengths,
                        const Cut* cut, Parameterization* result);

}  // namespace cirque

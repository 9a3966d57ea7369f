#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "cirque/core/metric.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/mesh/surface.h"
#include "cirque/pipeline/options.h"
#include "cirque/pipeline/parameterization.h"
#include "cirque/pipeline/summaries.h"

namespace cirque {

struct PrescribedRotations;
struct SolvedLayout;

/// What to parameterize for.
struct ParameterizeRequest {
  ParameterizeOptions options = {};
  /// The interval of every vertex's angle sum. Nothing: the cones that the options name
  /// (PlaceCones), or none where the surface is opened along the cut (SeamKind).
  std::optional<ConeTargets> targets = {};
  /// What is to be opened. Where that leaves no disks, or cones inside, more is opened. Nothing: a
  /// short cut through the cones is found.
  std::optional<Cut> cut = {};
  /// Of targets whose file missed Gauss-Bonnet by its digits, for the certificate.
  std::optional<ConeRoundingSummary> cone_rounding = {};
  /// Along loops of the surface's triangulation: measured, or met
  /// (intrinsic/loop_rotations.h); null: any.
  std::shared_ptr<const PrescribedRotations> rotations = {};
  /// With options.exact: puts the layout of what was solved where its exact map is to be drawn
  /// (pipeline/exact_layout.h); null: it stays.
  std::function<Status(SolvedLayout*)> place_exact = {};
  /// Whether the certificate is to say how much of a cut is seen (visible_cut_length): up to a twentieth of
  /// the time of a small closed surface.
  bool measure_visibility = true;
};

/// DefaultTargets (cone_stages.h) of a surface in space.
StatusOr<ConeTargets> DefaultTargets(const Surface& surface);

/// Maps a surface of any topology to the plane: intrinsic Delaunay flips, coherent angles, log
/// radii, a cut through the cones, layout. Where that leads to no map, or to one that misses
/// kAccuracy, other roads are tried unless the options are strict (pipeline/ladder.h); what was
/// asked for stays, and the certificate says which. The status is kInfeasible (the certificate
/// holds the proof), kUnrepresentable or kNotConverged when there is no map, kInvalidInput for
/// targets that fit no map and for a cut along edges inside polygons; `result` then carries no uv.
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

#pragma once

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/io/cone_file.h"
#include "cirque/pipeline/options.h"

namespace cirque {

/// Interior vertices flat, boundary vertices free. A closed surface: as many cones as those of
/// SimpleConeTargets, moved by `moving:measure=angle` unless they are more than 96.
StatusOr<ConeTargets> DefaultTargets(const Triangulation& triangulation,
                                     const EdgeLengths& lengths);

/// The targets that the options' cone heuristic chooses, sought on the metric's intrinsic Delaunay
/// connectivity, with the angles the options ask for; DefaultTargets when they name no heuristic.
/// `file`: how a cone file numbers the vertices; empty: in order. Errors (invalid input): an
/// unknown name or option, cones that Gauss-Bonnet or the corners forbid.
StatusOr<ConeTargets> PlaceCones(const IntrinsicSurface& surface, const FileVertices& file,
                                 const ParameterizeOptions& options);

}  // namespace cirque

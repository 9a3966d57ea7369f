#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/domains/sphere_normalization.h"
#include "cirque/pipeline/summaries.h"

namespace cirque {

/// Triangles in a plane that keep their side may lose it on the chords of the sphere: their vertices go
/// back to where they were `before`, in every further round with one ring more. False where triangles
/// stay flipped after ten rounds.
bool PutBackFlipped(const Triangulation& triangulation, const SphereChart& chart,
                    const PlaneWithPole& before, PlaneWithPole* refined);

/// Refines a map to the sphere without flipped triangles as ParameterizeOptions::refine_map says:
/// each of two overlapping caps, about the chart's centre and about infinity, in the plane of its
/// own stereographic projection, where what lies outside the cap and the pole stay. What that flips is
/// put back (PutBackFlipped). The refined map is taken if no triangle stays flipped and it has a lower
/// mean of q + 1/q - 2, q the ratio of singular values, weighted by the surface's area; else `plane`
/// stays as it was.
/// `lengths` are those of the surface. Errors: cancelled.
Status RefineOnSphere(const Triangulation& triangulation, const EdgeLengths& lengths,
                      const SphereChart& chart, const std::string& refine_map,
                      const std::atomic<bool>* cancelled, PlaneWithPole* plane,
                      std::optional<MapRefinementSummary>* summary);

}  // namespace cirque

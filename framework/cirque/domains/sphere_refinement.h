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

/// Refines a map to the sphere without flipped triangles as ParameterizeOptions::refine_map says:
/// each of two overlapping caps, about the chart's centre and about infinity, in the plane of its
/// own stereographic projection, where what lies outside the cap and the pole stay. The refined map
/// is taken if on the chords of the sphere it flips no triangle and has a lower mean of q + 1/q - 2,
/// q the ratio of singular values, weighted by the surface's area; else `plane` stays as it was.
/// `lengths` are those of the surface. Errors: cancelled.
Status RefineOnSphere(const Triangulation& triangulation, const EdgeLengths& lengths,
                      const SphereChart& chart, const std::string& refine_map,
                      const std::atomic<bool>* cancelled, PlaneWithPole* plane,
                      std::optional<MapRefinementSummary>* summary);

}  // namespace cirque

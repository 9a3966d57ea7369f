#pragma once

#include <vector>

#include "cirque/intrinsic/input_chart.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/pipeline/flat_surface.h"
#include "cirque/pipeline/summaries.h"

namespace cirque {

/// Untangles a job's flat metric as the input's triangles have it: moves single vertices
/// (UntangleFlippedTriangles), inner ones that are no cones. Counts flipped triangles before and
/// vertices moved in `summary`. Where no triangle is flipped but the triangles turn twice round a
/// vertex (their angles add up to a full turn more than in the flat metric), the faces there are
/// listed as flipped, so that they are kept from it.
///
/// `flat_angle_sums`, V [rad]: those of the flat metric.
void UntangleChart(const FlattenJob& job, const std::vector<double>& flat_angle_sums,
                   TriangulationSummary* summary, InputChart* chart);

}  // namespace cirque

#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/pipeline/options.h"

namespace cirque {

/// What it costs to open each edge of a surface, E, by the option `cut_cost`:
///   flat_length  its length in the flat metric
///   length       its length l on the surface: the cut is short to the eye
///   distortion   l / (1 + |u| / mean |u|), u the logarithm of its flat length over l, less its
///                mean: where the map is most distorted a seam changes least
///   curvature    l / (1 + K / mean K), K the mean |curvature| of its ends: seams hide in creases
///                and at tips, which the eye takes for seams anyway
/// times the factor that the file `edge_costs` gives it. Errors (invalid input): the file's.
StatusOr<Eigen::VectorXd> CutCosts(const IntrinsicSurface& surface, const EdgeLengths& flat_lengths,
                                   const ParameterizeOptions& options,
                                   const std::vector<Index>& vertex_in_file);

/// The length of the cut on the surface, over the square root of the surface's area.
double RelativeCutLength(const IntrinsicSurface& surface, const Cut& cut);

}  // namespace cirque

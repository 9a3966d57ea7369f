#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/cuts/cut_heuristic.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/pipeline/options.h"

namespace cirque {

/// What it costs to open each edge of a surface, E: by the heuristic that the options name
/// (CutHeuristics), or the caller's own, times the factor that the file `edge_costs` gives it. Errors
/// (invalid input): the heuristic's and the file's.
StatusOr<Eigen::VectorXd> CutCosts(const CutProblem& problem, const ParameterizeOptions& options,
                                   const std::vector<Index>& vertex_in_file);

/// The length of the cut on the surface, over the square root of the surface's area.
double RelativeCutLength(const IntrinsicSurface& surface, const Cut& cut);

/// The same with every edge counted by the share of 64 directions from which it is seen (Visibility);
/// of a long cut by that of a part of them, down to eight, each edge others than the one before.
double VisibleCutLength(const IntrinsicSurface& surface,
                        const std::vector<Eigen::Vector3d>& position, const Cut& cut);

}  // namespace cirque

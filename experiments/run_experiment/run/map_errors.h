#pragma once

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/status.h"
#include "cirque/domains/domain.h"
#include "cirque/generators/known_maps.h"
#include "cirque/mesh/surface.h"

#include "experiments/run_experiment/config/planned_run.h"

namespace cirque {

/// Where the known map has the corners of the surface.
std::vector<Eigen::Vector2d> KnownImage(const ConformalMap& map, const Surface& surface);

/// How far the map of a generated surface is from the smooth conformal map that its generator is
/// known to have, after the best similarity between the two, relative to the known image's
/// diameter: `known_map_rms_error`, `known_map_max_error`, and `edge_length`, the mean edge of the
/// known image by the same diameter. Empty for other meshes.
std::map<std::string, double> KnownMapErrors(const MeshSpec& mesh, const Surface& surface,
                                             const CornerUv& uv);

/// How far the map is from that of the surface subdivided once more, at the vertices that both have,
/// after the best similarity and relative to the image's diameter. Under a scheme that converges, as
/// Loop's, halving at every step by 2^p says that the maps do, at order p in the edge length. Empty
/// where an image has seams.
StatusOr<std::map<std::string, double>> RefinedMapErrors(const PlannedRun& run,
                                                         const Surface& surface,
                                                         const SurfaceMap& map);

}  // namespace cirque

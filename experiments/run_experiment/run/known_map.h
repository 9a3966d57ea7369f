#pragma once

#include <map>
#include <string>

#include "cirque/mesh/surface.h"

#include "experiments/run_experiment/config/config.h"

namespace cirque {

/// How far the map of a generated surface is from the smooth conformal map that its generator is
/// known to have, after the best similarity between the two, relative to the known image's
/// diameter: `known_map_rms_error`, `known_map_max_error`, and `edge_length`, the mean edge of the
/// known image by the same diameter. Empty for other meshes.
std::map<std::string, double> KnownMapErrors(const MeshSpec& mesh, const Surface& surface,
                                             const CornerUv& uv);

/// Interior vertices flat; boundary vertices fixed to the angle sums that they have in the known
/// image, whose smooth map the circle pattern must then converge to. @pre the mesh's generator has
/// a known map that maps a disk.
ConeTargets KnownBoundaryTargets(const MeshSpec& mesh, const Surface& surface);

}  // namespace cirque

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/status.h"
#include "cirque/domains/domain.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// Where a vertex is to go.
struct Pin {
  Index vertex = kNone;  ///< of the surface
  Eigen::Vector2d at = {0, 0};
};

/// The pins of a file: a line `vertex x y` each, vertices counted from 1 as in the mesh's file. '#'
/// begins a comment, empty lines are skipped. Errors (invalid input), each with file:line: not a whole
/// number and two finite ones; no such vertex; a vertex pinned twice, or to where another one is; none.
StatusOr<std::vector<Pin>> ParsePins(const std::string& path, std::string_view text,
                                     const Surface& surface);

StatusOr<std::vector<Pin>> ReadPins(const std::string& path, const Surface& surface);

/// Moves a map so that its pins lie where they are to: one is a translation, two are the similarity z ->
/// a z + b, which keep angles, exactly. More are MeetLandmarks from the similarity that comes nearest: by
/// the request's refine_map where that leaves conformality, else by the distortion of angles; with the
/// request's pin_weight. Certificate: PinSummary. Errors: kInvalidInput for a pin on the cut, which has
/// several places, and for all at one place of the map; kUnrepresentable where rounding flips triangles;
/// kNotConverged where pins are not met exactly that are to be; cancelled.
Status MoveToPins(const Surface& surface, const MapRequest& request, const std::vector<Pin>& pins,
                  const SolveControl& control, SurfaceMap* map);

}  // namespace cirque

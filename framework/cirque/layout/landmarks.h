#pragma once

#include <atomic>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/layout/opened_map.h"
#include "cirque/layout/refine_map.h"
#include "cirque/layout/stretch_energy.h"

namespace cirque {

/// Where a vertex of the surface, off the cut, is to lie.
struct Landmark {
  Index vertex;
  Eigen::Vector2d at;
};

/// How a map was led to its landmarks. Misses are the largest distance of one from its place, over the
/// square root of the image's area.
struct LandmarkFit {
  int steps = 0;
  double miss_before = 0, miss_after = 0;
  double energy_before = 0, energy_after = 0;
  bool exact = false;  ///< all lie exactly where they are to
};

/// Moves a map without flipped faces so that landmarks come to their places, by descent of
///   energy + weight sum |z_i - at_i|^2 / (image area * landmarks)
/// that flips no face (RefineStretch). weight 0: they are to lie there exactly. Then the weight rises a
/// hundredfold at a time from 1 until what is left can be moved without a flip, and the energy is lowered
/// once more with them held. Where it cannot be, `exact` is false and the map is as near as it came:
/// that a homotopy did not lead there is no proof that no map does. The energy's unit is the best for
/// the map as it comes. Errors: cancelled. @pre landmarks are different vertices, off the cut.
StatusOr<LandmarkFit> MeetLandmarks(const SeamedSurface& of, StretchEnergy energy,
                                    const RefineStretchOptions& options,
                                    const std::vector<Landmark>& landmarks, double weight,
                                    const std::atomic<bool>* cancelled, CornerUv* uv);

}  // namespace cirque

#pragma once

#include <string>
#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/domains/domain.h"
#include "cirque/domains/sphere_normalization.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// Places a laid-out plane with a pole on the unit sphere: normalises it as DomainOptions say and
/// refines it as ParameterizeOptions::refine_map does. Writes the positions of the map, and in its
/// certificate what the normalisation took, the centre of mass, the refinement and the flips.
class SpherePlacement {
 public:
  SpherePlacement(const Surface& surface, const EdgeLengths& lengths, const DomainOptions& options,
                  std::string refine_map, const SolveControl& control, SurfaceMap* map);

  /// Refines a map that is good already; where the refined one is not, it stays. Errors: the
  /// normalisation's (NormalizeChart), cancelled.
  Status Place(PlaneWithPole plane);

  /// Of the positions that the map has.
  void FindFlipped();

  const std::vector<Index>& flipped() const { return flipped_; }  ///< of the input's faces
  /// False: no other pole or triangulation would help.
  bool is_normalized() const { return normalized_; }

 private:
  Status RefineThenNormalize(PlaneWithPole plane);
  Status Normalize(const PlaneWithPole& plane);

  const Surface& surface_;
  const EdgeLengths& lengths_;
  const DomainOptions& options_;
  const std::string refine_map_;
  const SolveControl& control_;
  SurfaceMap& map_;
  SphereChart chart_;  ///< of the last normalisation
  std::vector<Index> flipped_;
  bool normalized_ = true;
};

}  // namespace cirque
